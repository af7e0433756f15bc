//! What changes the kinetic energy of a motion.

use super::Scene;

/// Something that does work.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Work {
    /// Its name, as `spring`; with a number if there are several of a kind, as `drag_2`.
    pub name: String,
    /// Its number among the scene's forces; for what payloads bring and take the number of these.
    pub(crate) number: usize,
}

impl Scene {
    /// What does work: the forces that can, in their order, then `payloads` if any is taken or let go. The kinetic energy changes by the
    /// sum of all.
    pub fn works(&self) -> Vec<Work> {
        let names: Vec<_> = self.forces.iter().map(|named| named.force.work()).collect();
        let several = |name| names.iter().filter(|other| **other == Some(name)).count() > 1;
        let each = names.iter().enumerate().filter_map(|(number, name)| {
            let name = (*name)?;
            let before = names[..number].iter().filter(|other| **other == Some(name)).count();
            let name = if several(name) { format!("{name}_{}", before + 1) } else { name.to_owned() };
            Some(Work { name, number })
        });
        let payloads = Work { name: "payloads".to_owned(), number: names.len() };
        each.chain((!self.handovers().is_empty()).then_some(payloads)).collect()
    }
}
