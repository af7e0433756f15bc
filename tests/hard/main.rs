//! Robots and motions at which naive formulas fail, each judged by evaluations with 31 digits.

mod light_base;
