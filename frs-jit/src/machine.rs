//! Machine code: made by Cranelift, called, given back. The only file of the project with `unsafe` in it.

use cranelift_codegen::Context;
use cranelift_codegen::ir::AbiParam;
use cranelift_codegen::settings::{self, Configurable, Flags};
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{FuncId, Module, default_libcall_names};
use frs_codegen::record::Operation;

use crate::error::JitError;
use crate::order::Order;
use crate::translate::Translation;

/// What the compiler is asked for.
const FLAGS: [(&str, &str); 5] = [
    // The graph is folded already; Cranelift's optimiser undoes the order, and calls take a tenth longer.
    ("opt_level", "none"),
    // `single_pass` takes a third of the time to compile; each call then takes nearly twice as long.
    ("regalloc_algorithm", "backtracking"),
    ("enable_verifier", if cfg!(debug_assertions) { "true" } else { "false" }),
    ("probestack_strategy", "inline"),
    ("is_pic", "false"),
];

/// A function of machine code: addresses of the inputs, memory, addresses of the outputs.
type Function = unsafe extern "C" fn(*const *const f64, *mut f64, *const *mut f64);

/// Most slices of inputs or of outputs: their addresses stand on the stack during a call.
pub const SLICES: usize = 8;

/// Lengths of what machine code reads and writes.
#[derive(Debug)]
pub struct Lengths {
    /// Of each slice of inputs.
    pub inputs: Vec<usize>,
    /// Of the memory.
    pub memory: usize,
    /// Of each slice of outputs.
    pub outputs: Vec<usize>,
}

/// Functions of machine code, and the memory in which they lie.
pub struct Machine {
    /// None only while the memory is given back.
    module: Option<JITModule>,
    functions: Vec<Function>,
    lengths: Lengths,
    bytes: usize,
}

impl Machine {
    /// Compiles the parts of `order`, for slices of these lengths.
    ///
    /// # Errors
    /// If this machine cannot be compiled for, or has no memory left.
    pub fn new(operations: &[Operation], order: &Order, lengths: Lengths) -> Result<Self, JitError> {
        let mut machine = Self { module: None, functions: Vec::new(), lengths, bytes: 0 };
        let module = machine.module.insert(module()?);
        let pointer = module.target_config().pointer_type();
        let mut signature = module.make_signature();
        signature.params = vec![AbiParam::new(pointer); 3];
        let mut context = Context::new();
        let mut compiled = Vec::new();
        for part in &order.parts {
            context.clear();
            context.func.signature = signature.clone();
            Translation::new(operations, order, &machine.lengths, &mut context.func, pointer).part(part);
            let function = module.declare_anonymous_function(&signature).map_err(Box::new)?;
            module.define_function(function, &mut context).map_err(Box::new)?;
            machine.bytes += context.compiled_code().map_or(0, |code| code.code_info().total_size as usize);
            compiled.push(function);
        }
        module.finalize_definitions().map_err(Box::new)?;
        machine.functions = compiled.into_iter().map(|function| entry(module, function)).collect();
        Ok(machine)
    }

    /// Lengths of what it reads and writes.
    pub fn lengths(&self) -> &Lengths {
        &self.lengths
    }

    /// Length of the machine code in bytes.
    pub fn bytes(&self) -> usize {
        self.bytes
    }

    /// Performs one part after the other, and `between` with the memory after each.
    ///
    /// # Panics
    /// If a slice is missing or has not its length.
    #[allow(unsafe_code, reason = "machine code that was made at run time has no other way to be called")]
    pub fn call(
        &self,
        inputs: &[&[f64]],
        memory: &mut [f64],
        outputs: &mut [&mut [f64]],
        mut between: impl FnMut(usize, &mut [f64]),
    ) {
        let Lengths { inputs: input, memory: slots, outputs: output } = &self.lengths;
        let fits = inputs.iter().map(|slice| slice.len()).eq(input.iter().copied())
            && outputs.iter().map(|slice| slice.len()).eq(output.iter().copied())
            && memory.len() == *slots;
        assert!(fits, "inputs and outputs must have the lengths for which the code was compiled");
        let (mut from, mut to) = ([std::ptr::null(); SLICES], [std::ptr::null_mut(); SLICES]);
        from.iter_mut().zip(inputs).for_each(|(address, slice)| *address = slice.as_ptr());
        to.iter_mut().zip(outputs).for_each(|(address, slice)| *address = slice.as_mut_ptr());
        for (part, function) in self.functions.iter().enumerate() {
            // SAFETY: the function was compiled for this processor, has this signature, and lies in memory that `self` holds.
            // It reads the inputs, reads and writes the memory, writes the outputs, each below the length that was just checked
            // (`Code` refuses inputs beyond it, `Order` numbers slots and outputs), and does nothing else.
            unsafe { function(from.as_ptr(), memory.as_mut_ptr(), to.as_ptr()) };
            between(part, memory);
        }
    }
}

impl Drop for Machine {
    #[allow(unsafe_code, reason = "Cranelift keeps the memory for ever unless it is told that nobody calls into it")]
    fn drop(&mut self) {
        if let Some(module) = self.module.take() {
            // SAFETY: the pointers into this memory are in `functions`, which is private, never copied out and gone with `self`;
            // nobody is within one of them, for `call` borrows `self`.
            unsafe { module.free_memory() }
        }
    }
}

/// Where a finished function begins.
#[allow(unsafe_code, reason = "Cranelift hands out addresses, whatever the signature")]
fn entry(module: &JITModule, function: FuncId) -> Function {
    let address = module.get_finalized_function(function);
    // SAFETY: every function is declared with three pointers, without a result, with and this platform's C calling convention.
    unsafe { std::mem::transmute::<*const u8, Function>(address) }
}

/// What code calls where the processor has no instruction for it.
extern "C" fn fma(a: f64, b: f64, c: f64) -> f64 {
    a.mul_add(b, c)
}

/// A compiler for the processor this runs on.
fn module() -> Result<JITModule, JitError> {
    let no = |error: &dyn std::fmt::Display| JitError::NoJit(error.to_string());
    let mut flags = settings::builder();
    for (name, value) in FLAGS {
        flags.set(name, value).map_err(|error| no(&error))?;
    }
    let processor = cranelift_native::builder().map_err(|error| no(&error))?;
    let target = processor.finish(Flags::new(flags)).map_err(|error| no(&error))?;
    let mut builder = JITBuilder::with_isa(target, default_libcall_names());
    builder.symbol("fma", fma as *const u8);
    Ok(JITModule::new(builder))
}
