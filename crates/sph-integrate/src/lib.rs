//! Time integration without physics: stabilised explicit super steps, reference schemes, named step limits.
