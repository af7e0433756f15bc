//! States to the generated program and to the core, answers to the comparison.

use std::io::{self, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout};
use std::sync::mpsc::{SyncSender, sync_channel};
use std::thread;

use frs::{Evaluator, Model};
use frs_codegen::FunctionReport;
use indicatif::{ProgressBar, ProgressStyle};

use super::compare::Comparison;
use super::element::Element;
use super::harness::Harness;
use super::reference::{Question, laden, part};
use super::states::{Layout, States};
use super::time::nanoseconds;

/// Numbers that a block of answers should not exceed, so that memory stays small whatever the robot.
const BLOCK: usize = 1 << 18;

/// Most states of a block.
const BLOCK_STATES: usize = 1024;

/// States over which times are measured.
const TIMED_STATES: usize = 64;

/// What to compare.
pub struct Run<'r, E: Element> {
    /// The robot, with held coordinates held.
    pub model: Model<E>,
    /// The link whose parameters are inputs.
    pub payload: Option<&'r str>,
    /// The generated functions.
    pub functions: &'r [FunctionReport],
    /// Their inputs.
    pub layout: Layout,
    /// States that the program evaluates at once.
    pub lanes: usize,
    /// Of the random states.
    pub seed: u64,
}

/// What came out.
pub struct Outcome {
    /// How many states were compared, and how many of them are hard ones.
    pub states: [usize; 2],
    /// The comparison.
    pub comparison: Comparison,
    /// Nanoseconds per state of generated code and of the core, for each function.
    pub times: Vec<[f64; 2]>,
}

/// States, and what to do with them.
struct Block<E> {
    states: Vec<Vec<E>>,
    measure: bool,
}

impl<E: Element> Run<'_, E> {
    /// Compares at hard states and at `random` others, then measures.
    pub fn all(&self, harness: &Harness, random: usize) -> Result<Outcome, String> {
        let mut program = harness.start()?;
        let (Some(input), Some(mut answers)) = (program.stdin.take(), program.stdout.take()) else {
            return Err("the program has no standard input and output".into());
        };
        let mut states = States::new(&self.model, self.layout.clone(), self.seed);
        let hard = states.hard();
        // The last group is filled up.
        let total = (hard + random).next_multiple_of(self.lanes);
        let outcome = thread::scope(|scope| {
            let (sender, blocks) = sync_channel(2);
            scope.spawn(move || self.feed(input, &sender, &mut states, total));
            let bar = progress(total);
            let mut comparison = Comparison::new(self.functions.len());
            let mut seen = 0;
            for Block { states, measure } in blocks {
                if measure {
                    bar.finish_and_clear();
                    let times = self.measure(&mut answers, &states)?;
                    return Ok(Outcome { states: [seen, hard], comparison, times });
                }
                self.compare(&mut answers, &states, seen, &mut comparison)?;
                seen += states.len();
                bar.set_position(seen as u64);
            }
            Err(io::ErrorKind::UnexpectedEof.into())
        });
        outcome.map_err(|error: io::Error| ended(&mut program, &error))
    }

    /// Writes blocks of states to the program, and gives them to whoever compares; stops when nobody reads.
    fn feed(&self, mut input: ChildStdin, blocks: &SyncSender<Block<E>>, states: &mut States<E>, total: usize) {
        let room = (BLOCK / self.numbers()).clamp(1, BLOCK_STATES).next_multiple_of(self.lanes);
        let mut left = total;
        while left > 0 {
            let count = left.min(room);
            left -= count;
            let block = Block { states: states.take(count).collect(), measure: false };
            if !self.send(&mut input, blocks, block) {
                return;
            }
        }
        let states = (0..TIMED_STATES.next_multiple_of(self.lanes)).map(|_| states.random()).collect();
        self.send(&mut input, blocks, Block { states, measure: true });
    }

    /// Whether somebody still reads.
    fn send(&self, input: &mut ChildStdin, blocks: &SyncSender<Block<E>>, block: Block<E>) -> bool {
        let mut bytes = Vec::new();
        bytes.extend(((block.states.len() / self.lanes) as u32).to_le_bytes());
        bytes.extend(u32::from(block.measure).to_le_bytes());
        block.states.iter().flatten().for_each(|number| number.write(&mut bytes));
        blocks.send(block).is_ok() && input.write_all(&bytes).is_ok()
    }

    /// Reads the program's answers to a block and compares them with the core's.
    fn compare(
        &self,
        answers: &mut ChildStdout,
        states: &[Vec<E>],
        seen: usize,
        comparison: &mut Comparison,
    ) -> io::Result<()> {
        let mut bytes = vec![0; states.len() * self.numbers() * E::BYTES];
        answers.read_exact(&mut bytes)?;
        let mut questions = self.questions();
        self.each_state(states, |evaluator, number, state| {
            let mut start = 0;
            for (index, (function, question)) in self.functions.iter().zip(&mut questions).enumerate() {
                question.ask(evaluator, state);
                // Function by function, group by group, number by number, lane by lane.
                let (len, group, lane) = (numbers(function), number / self.lanes, number % self.lanes);
                let generated = (0..len).map(|entry| {
                    let place = start + (group * len + entry) * self.lanes + lane;
                    E::read(&bytes[place * E::BYTES..][..E::BYTES])
                });
                comparison.see((index, function), (seen + number, state), generated, question.answer());
                start += states.len() * len;
            }
        });
        Ok(())
    }

    /// Reads the program's times and measures the core's.
    fn measure(&self, answers: &mut ChildStdout, states: &[Vec<E>]) -> io::Result<Vec<[f64; 2]>> {
        let mut bytes = vec![0; self.functions.len() * f64::BYTES];
        answers.read_exact(&mut bytes)?;
        let generated: Vec<f64> = bytes.chunks_exact(f64::BYTES).map(f64::read).collect();
        let mut core = Vec::new();
        self.each_state(&states[..1], |evaluator, _, _| {
            let questions = self.questions().into_iter();
            core = questions
                .map(|mut question| nanoseconds(|| states.iter().for_each(|state| question.ask(evaluator, state))))
                .collect();
        });
        let per_state = |time: f64| time / states.len() as f64;
        Ok(generated.into_iter().zip(core).map(|pair| <[f64; 2]>::from(pair).map(per_state)).collect())
    }

    /// Gives each state to `visit`, with the robot of that state and the state's number.
    fn each_state(&self, states: &[Vec<E>], mut visit: impl FnMut(&mut Evaluator<'_, E>, usize, &[E])) {
        let payload = self.layout.inputs.iter().find(|input| input.name == "payload").zip(self.payload);
        let Some((input, link)) = payload else {
            let mut evaluator = Evaluator::new(&self.model);
            return states.iter().enumerate().for_each(|(number, state)| visit(&mut evaluator, number, state));
        };
        for (number, state) in states.iter().enumerate() {
            let model = laden(&self.model, link, part(state, input));
            visit(&mut Evaluator::new(&model), number, state);
        }
    }

    fn questions(&self) -> Vec<Question<E>> {
        self.functions.iter().map(|function| Question::new(function, self.model.dof())).collect()
    }

    /// Numbers that all functions write.
    fn numbers(&self) -> usize {
        self.functions.iter().map(numbers).sum()
    }
}

/// Numbers that a function writes.
fn numbers(function: &FunctionReport) -> usize {
    function.outputs.iter().map(|(_, [rows, columns], layers)| rows * columns * layers).sum()
}

/// Shown on a terminal only.
fn progress(total: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("comparing {wide_bar} {human_pos} of {human_len} states, {eta} left");
    ProgressBar::new(total as u64).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// Why there are no more answers.
fn ended(program: &mut Child, error: &io::Error) -> String {
    match program.wait() {
        Ok(status) => format!("the generated program ended before it had answered all states: {status}"),
        Err(_) => format!("the generated program does not answer: {error}"),
    }
}
