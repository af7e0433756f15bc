//! The plain numbers that generated code computes with, as bits on a pipe.

use std::fmt::Debug;

use frs::Real;

/// `f64` or `f32`.
pub trait Element: Real + Debug + Send + Sync {
    /// Its type's name.
    const NAME: &'static str;
    /// Its length in bytes.
    const BYTES: usize;

    /// Its bits.
    fn bits(self) -> u64;

    /// As a double, exactly.
    fn double(self) -> f64;

    /// From little-endian bytes.
    fn read(bytes: &[u8]) -> Self;

    /// To little-endian bytes.
    fn write(self, bytes: &mut Vec<u8>);
}

macro_rules! element {
    ($number:ident) => {
        impl Element for $number {
            const NAME: &'static str = stringify!($number);
            const BYTES: usize = size_of::<$number>();

            fn bits(self) -> u64 {
                self.to_bits().into()
            }

            fn double(self) -> f64 {
                self.into()
            }

            fn read(bytes: &[u8]) -> Self {
                let mut own = [0; size_of::<$number>()];
                own.copy_from_slice(bytes);
                Self::from_le_bytes(own)
            }

            fn write(self, bytes: &mut Vec<u8>) {
                bytes.extend(self.to_le_bytes());
            }
        }
    };
}

element!(f64);
element!(f32);
