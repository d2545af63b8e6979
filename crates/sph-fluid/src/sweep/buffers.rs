//! Row buffers that pieces of work take in turns.

use sph_kernel::RowBuffer;
use std::ops::{Deref, DerefMut};
use std::sync::{Mutex, PoisonError};

/// As many buffers as were ever in use at once: passes over rows allocate nothing once there are enough.
#[derive(Debug, Default)]
pub(crate) struct Buffers<const D: usize>(Mutex<Vec<RowBuffer<D>>>);

/// A buffer that goes back when it is dropped.
#[derive(Debug)]
pub(crate) struct Taken<'a, const D: usize> {
    home: &'a Buffers<D>,
    buffer: RowBuffer<D>,
}

impl<const D: usize> Buffers<D> {
    /// One that nobody uses, or a new one.
    pub fn take(&self) -> Taken<'_, D> {
        Taken { home: self, buffer: self.idle().pop().unwrap_or_default() }
    }

    /// A panic elsewhere leaves whole buffers.
    fn idle(&self) -> std::sync::MutexGuard<'_, Vec<RowBuffer<D>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl<const D: usize> Clone for Buffers<D> {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl<const D: usize> Deref for Taken<'_, D> {
    type Target = RowBuffer<D>;

    fn deref(&self) -> &RowBuffer<D> {
        &self.buffer
    }
}

impl<const D: usize> DerefMut for Taken<'_, D> {
    fn deref_mut(&mut self) -> &mut RowBuffer<D> {
        &mut self.buffer
    }
}

impl<const D: usize> Drop for Taken<'_, D> {
    fn drop(&mut self) {
        self.home.idle().push(std::mem::take(&mut self.buffer));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_buffer_comes_back_and_two_at_once_are_two() {
        let buffers = Buffers::<2>::default();
        *buffers.take() = RowBuffer::with_capacity(9);
        let again = buffers.take();
        let other = buffers.take();
        assert_eq!((again.capacity(), other.capacity()), (9, 0));
    }
}
