//! What generated robots share: from flat slices to arrays, and how they refuse.

use crate::Quantity;
pub use crate::model::{BodyTable, Drive, LinkTable, Motion, Tables};

/// The source of [`turn`](crate::turn), for robots that stand alone.
pub const TURN: &str = include_str!("turn.rs");

const SIZES: &str = "inputs and outputs must be those that the quantity lists, each of its length";

/// A slice as an array.
///
/// # Panics
/// If it has not `N` numbers, like everything here.
pub fn array<T, const N: usize>(slice: &[T]) -> &[T; N] {
    slice.try_into().expect(SIZES)
}

/// A slice as an array to write to.
pub fn array_mut<T, const N: usize>(slice: &mut [T]) -> &mut [T; N] {
    slice.try_into().expect(SIZES)
}

/// A slice of one number.
pub fn number_mut<T>(slice: &mut [T]) -> &mut T {
    let [number] = array_mut::<T, 1>(slice);
    number
}

/// A slice as the `C` columns of a matrix of `R` rows.
pub fn columns_mut<T, const R: usize, const C: usize>(slice: &mut [T]) -> &mut [[T; R]; C] {
    let (columns, rest) = slice.as_chunks_mut::<R>();
    assert!(rest.is_empty(), "{SIZES}");
    columns.try_into().expect(SIZES)
}

/// A slice as `L` matrices of `C` columns and `R` rows.
pub fn layers_mut<T, const R: usize, const C: usize, const L: usize>(slice: &mut [T]) -> &mut [[[T; R]; C]; L] {
    let (columns, rest) = slice.as_chunks_mut::<R>();
    let (layers, more) = columns.as_chunks_mut::<C>();
    assert!(rest.is_empty() && more.is_empty(), "{SIZES}");
    layers.try_into().expect(SIZES)
}

/// Says why a robot does not answer.
///
/// # Panics
/// Always.
pub fn refuse(quantity: Quantity, generated: bool) -> ! {
    if generated {
        panic!("{SIZES}");
    }
    panic!("{quantity:?} was not generated for this robot; add it to its outputs");
}
