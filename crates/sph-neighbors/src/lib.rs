//! Fixed-radius neighbour lists: cell grid and k-d tree behind one interface, spatial sort, skin and reuse.
