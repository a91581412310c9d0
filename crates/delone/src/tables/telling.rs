//! The tables, observed: what they number, told in the names of vertices.

use super::{Row, Tables};
use crate::{Event, Observer, VertexId};

/// Someone who is told, the line of pseudocode that runs, and what the vertices are called.
pub(crate) struct Teller<'r, O> {
    names: Names,
    line: u16,
    observer: &'r mut O,
}

/// For each number of a vertex its name.
#[derive(Clone, Debug, Default)]
pub(crate) struct Names(Vec<VertexId>);

impl Names {
    /// Names vertices, by their numbers.
    pub fn of<const N: usize>(&self, numbers: [u32; N]) -> [VertexId; N] {
        numbers.map(|v| self.0[v as usize])
    }
}

impl<'r, O: Observer> Teller<'r, O> {
    /// Begins with the names of the vertices that there are.
    pub fn new(names: Vec<VertexId>, observer: &'r mut O) -> Self {
        Self {
            names: Names(names),
            line: 0,
            observer,
        }
    }

    /// Returns what the vertices are called.
    pub fn names(&self) -> &Names {
        &self.names
    }

    /// Names the vertex of the next number, which is returned.
    pub fn add_name(&mut self, name: VertexId) -> u32 {
        self.names.0.push(name);
        self.names.0.len() as u32 - 1
    }

    /// States which line of pseudocode runs from here on.
    #[inline]
    pub fn at(&mut self, line: u16) {
        self.line = line;
    }

    /// Tells whether anybody listens.
    #[inline]
    pub fn is_watching(&self) -> bool {
        self.observer.is_watching()
    }

    /// Tells of something, if anybody listens.
    #[inline]
    pub fn tell(&mut self, event: impl FnOnce(&Names) -> Event) {
        let names = &self.names;
        self.observer.tell(self.line, || event(names));
    }

    /// [`Tables::bisect`], and tells of it.
    pub fn bisect(&mut self, tables: &mut Tables, row: u32, x: u32) -> Vec<u32> {
        let Row { first, second, .. } = *tables.row(row);
        let slots = [Some(first), second].into_iter().flatten();
        let slots = slots.map(|side| side.triangle);
        self.edit(tables, slots, Some(row), |tables| tables.bisect(row, x))
    }

    /// [`Tables::insert`], and tells of it.
    pub fn insert(&mut self, tables: &mut Tables, t: u32, x: u32) -> Vec<u32> {
        self.edit(tables, [t].into_iter(), None, |tables| tables.insert(t, x))
    }

    /// Makes an edit that writes these triangles and perhaps a row, and appends others.
    fn edit<E>(
        &mut self,
        tables: &mut Tables,
        slots: impl Iterator<Item = u32> + Clone,
        row: Option<u32>,
        edit: impl FnOnce(&mut Tables) -> E,
    ) -> E {
        if !self.is_watching() {
            return edit(tables);
        }
        let [rows, triangles] = [tables.rows.len(), tables.triangles.len()].map(|n| n as u32);
        self.tell_going(tables, slots.clone(), row);
        let edited = edit(tables);
        let slots = slots.chain(triangles..tables.triangles.len() as u32);
        self.tell_coming(
            tables,
            slots,
            row.into_iter().chain(rows..tables.rows.len() as u32),
        );
        edited
    }

    fn tell_going(&mut self, tables: &Tables, slots: impl Iterator<Item = u32>, row: Option<u32>) {
        for t in slots {
            let corners = tables.triangles[t as usize];
            self.tell(|names| Event::TriangleDeleted {
                triangle: names.of(corners),
            });
        }
        if let Some(row) = row.map(|row| tables.row(row)) {
            let edge = self.names.of(row.ends);
            if row.is_constraint {
                self.tell(|_| Event::EdgeUnlocked { edge });
            }
            self.tell(|_| Event::EdgeDeleted { edge });
        }
    }

    fn tell_coming(
        &mut self,
        tables: &Tables,
        slots: impl Iterator<Item = u32>,
        rows: impl Iterator<Item = u32>,
    ) {
        for row in rows.map(|row| tables.row(row)) {
            let edge = self.names.of(row.ends);
            self.tell(|_| Event::EdgeCreated { edge });
            if row.is_constraint {
                self.tell(|_| Event::EdgeLocked { edge });
            }
        }
        for t in slots {
            let corners = tables.triangles[t as usize];
            self.tell(|names| Event::TriangleCreated {
                triangle: names.of(corners),
            });
        }
    }
}
