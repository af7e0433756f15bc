//! The core and generated code against robots that are known in closed form.

/// One test a case, named after it: `relation(Case::P1)`, ….
macro_rules! of_cases {
    ($relation:ident: $($name:ident $case:ident),*) => {
        mod $relation {
            $(
                #[test]
                fn $name() {
                    super::$relation(frs_oracles::Case::$case);
                }
            )*
        }
    };
}

/// [`of_cases`] with all of them.
macro_rules! every_case {
    ($relation:ident) => {
        of_cases!($relation: p1 P1, p2 P2, p3 P3, p4 P4, p5 P5, p6 P6, p7 P7, p8 P8, p9 P9, s0 S0, g1 G1, g2 G2,
            d1 D1, d2 D2, d3 D3, d4 D4, d5 D5, c1 C1, c2 C2, m1 M1, m2 M2);
    };
}

/// [`of_cases`] with those that have two coordinates or more.
macro_rules! every_case_with_pairs {
    ($relation:ident) => {
        of_cases!($relation: p3 P3, p5 P5, p6 P6, p7 P7, p8 P8, p9 P9, s0 S0, g1 G1, g2 G2,
            d1 D1, d2 D2, d3 D3, d4 D4, d5 D5, c1 C1, c2 C2, m1 M1, m2 M2);
    };
}

mod bianchi;
mod definition;
mod extended;
mod flatness;
mod loops;
mod other_roots;
mod points;
mod pullback;
mod random;
mod restriction;
mod robots;
