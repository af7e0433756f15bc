//! Which instructions perform a recording: the widest that the processor has. The only file of the crate with `unsafe` in it.

use crate::perform::{Block, perform};
use crate::steps::Step;

/// Sets of instructions, from narrow to wide. All give the same bits: each number is computed by itself, and nothing is contracted that was not recorded so.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Instructions {
    /// Those for which the program was compiled.
    Compiled,
    /// Four doubles at once on x86-64, fused products among them.
    Avx2,
    /// Eight doubles at once on x86-64.
    Avx512,
}

impl Instructions {
    /// All, from narrow to wide.
    pub const ALL: [Self; 3] = [Self::Compiled, Self::Avx2, Self::Avx512];

    /// The widest that this processor has.
    pub fn widest() -> Self {
        Self::ALL.into_iter().rev().find(|instructions| instructions.are_here()).unwrap_or(Self::Compiled)
    }

    /// Whether this processor has them.
    pub fn are_here(self) -> bool {
        match self {
            Self::Compiled => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma"),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => is_x86_feature_detected!("avx512f"),
            #[cfg(not(target_arch = "x86_64"))]
            Self::Avx2 | Self::Avx512 => false,
        }
    }

    /// Their name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Compiled => "as compiled",
            Self::Avx2 => "AVX2",
            Self::Avx512 => "AVX-512",
        }
    }

    /// Performs `steps` by these instructions, or as compiled where the processor has them not; returns by which.
    #[allow(unsafe_code, reason = "only the processor can say at run time whether it has these instructions")]
    pub(crate) fn perform(self, steps: &[Step], memory: &mut [Block]) -> Self {
        match self {
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 if self.are_here() => {
                // SAFETY: the processor has just said that it has AVX-512F.
                unsafe { perform_avx512(steps, memory) };
                Self::Avx512
            }
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 if self.are_here() => {
                // SAFETY: the processor has just said that it has AVX2 and FMA.
                unsafe { perform_avx2(steps, memory) };
                Self::Avx2
            }
            _ => {
                perform(steps, memory);
                Self::Compiled
            }
        }
    }
}

/// [`perform`] by AVX2.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn perform_avx2(steps: &[Step], memory: &mut [Block]) {
    perform(steps, memory);
}

/// [`perform`] by AVX-512.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f")]
fn perform_avx512(steps: &[Step], memory: &mut [Block]) {
    perform(steps, memory);
}
