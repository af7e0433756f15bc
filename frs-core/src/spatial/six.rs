//! What twists and wrenches share: each is a vector space of six numbers, angular part first.

/// Constructors and linear operations of a six-vector type with the given angular and linear fields.
macro_rules! six_vector {
    ($name:ident, $angular:ident, $linear:ident) => {
        impl<T: Real> $name<T> {
            #[doc = concat!("The six-vector `[", stringify!($angular), "; ", stringify!($linear), "]`.")]
            #[inline(always)]
            pub fn new($angular: Vector3<T>, $linear: Vector3<T>) -> Self {
                Self { $angular, $linear }
            }

            /// The six-vector 0.
            #[inline(always)]
            pub fn zero() -> Self {
                Self::new(Vector3::zeros(), Vector3::zeros())
            }

            /// Reads six numbers, angular part first.
            #[inline(always)]
            pub fn from_array([a, b, c, d, e, f]: [T; 6]) -> Self {
                Self::new(Vector3::new(a, b, c), Vector3::new(d, e, f))
            }

            /// Writes six numbers, angular part first.
            #[inline(always)]
            pub fn to_array(self) -> [T; 6] {
                let (a, l) = (self.$angular, self.$linear);
                [a.x, a.y, a.z, l.x, l.y, l.z]
            }

            /// Writes a vector of six, angular part first.
            #[inline(always)]
            pub fn to_vector(self) -> Vector6<T> {
                Vector6::from(self.to_array())
            }

            /// `self + other·factor`, rounded as [`Real::plus_product`] rounds.
            #[inline(always)]
            pub fn plus_scaled(self, other: Self, factor: T) -> Self {
                if !FUSED {
                    return self + other * factor;
                }
                Self::new(
                    plus_scaled(self.$angular, other.$angular, factor),
                    plus_scaled(self.$linear, other.$linear, factor),
                )
            }

            /// `self − other·factor`, rounded as [`Real::plus_product`] rounds.
            #[inline(always)]
            pub fn minus_scaled(self, other: Self, factor: T) -> Self {
                if FUSED { self.plus_scaled(other, -factor) } else { self - other * factor }
            }
        }

        impl<T: Real> std::ops::Add for $name<T> {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                Self::new(self.$angular + other.$angular, self.$linear + other.$linear)
            }
        }

        impl<T: Real> std::ops::AddAssign for $name<T> {
            #[inline(always)]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }

        impl<T: Real> std::ops::Sub for $name<T> {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                Self::new(self.$angular - other.$angular, self.$linear - other.$linear)
            }
        }

        impl<T: Real> std::ops::Neg for $name<T> {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self::new(-self.$angular, -self.$linear)
            }
        }

        impl<T: Real> std::ops::Mul<T> for $name<T> {
            type Output = Self;
            #[inline(always)]
            fn mul(self, factor: T) -> Self {
                Self::new(self.$angular * factor, self.$linear * factor)
            }
        }
    };
}

pub(super) use six_vector;
