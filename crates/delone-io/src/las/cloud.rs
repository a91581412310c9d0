//! Points as they are picked out of records.

use super::header::Header;
use crate::decimal::Axis;
use crate::{Attribute, Error, Place, PointSet, Problem, ReadOptions, Returns, node};
use delone::{Phase, Point, Watch};

/// The points that have been kept, and what goes with them.
pub(super) struct Cloud<'a> {
    file: &'a str,
    options: &'a ReadOptions,
    watch: &'a dyn Watch,
    axes: [Axis; 3],
    record: usize,
    /// Whether the records are those of formats 6 to 10.
    is_extended: bool,
    declared: u64,
    /// Records seen so far.
    pub seen: u64,
    points: Vec<Point>,
    z: Vec<f64>,
    classes: Vec<u8>,
    intensities: Vec<u16>,
    /// Number of the return, and of all returns of the pulse.
    returns: [Vec<u8>; 2],
    /// The classes that there are, kept or not.
    present: [bool; 256],
}

/// What a record says beside the place.
struct Pulse {
    class: u8,
    /// Number of the return, and of all returns of the pulse.
    returns: [u8; 2],
    is_withheld: bool,
}

impl<'a> Cloud<'a> {
    /// Begins with room for as many points as there can be in so many bytes of records.
    pub fn new(
        file: &'a str,
        header: &Header,
        most: u64,
        options: &'a ReadOptions,
        watch: &'a dyn Watch,
    ) -> Result<Self, Error> {
        let mut cloud = Self {
            file,
            options,
            watch,
            axes: header.axes,
            record: header.record,
            is_extended: header.format >= 6,
            declared: header.points,
            seen: 0,
            points: Vec::new(),
            z: Vec::new(),
            classes: Vec::new(),
            intensities: Vec::new(),
            returns: [Vec::new(), Vec::new()],
            present: [false; 256],
        };
        if !cloud.chooses() {
            if header.points.min(most) > node::MAX_POINTS {
                return Err(cloud.malformed(node::too_many(header.points)));
            }
            // Without memory for so many, the vectors grow with the points that do come.
            let room = usize::try_from(header.points.min(most)).unwrap_or(0);
            drop(cloud.points.try_reserve_exact(room));
            drop(cloud.z.try_reserve_exact(room));
        }
        Ok(cloud)
    }

    /// Tells whether not all points are wanted.
    fn chooses(&self) -> bool {
        !self.options.classes.is_empty() || self.options.returns != Returns::All
    }

    fn malformed(&self, problem: Problem) -> Error {
        Error::Malformed {
            file: self.file.to_owned(),
            place: Place::File,
            problem,
        }
    }

    /// Makes the error of a file that ends too early.
    pub fn truncated(&self) -> Error {
        self.malformed(Problem::Truncated {
            items: "points",
            declared: self.declared,
            found: self.seen,
        })
    }

    /// Takes records, reports how many, and fails if cancelled.
    pub fn take(&mut self, records: &[u8]) -> Result<(), Error> {
        if self.watch.is_cancelled() {
            return Err(Error::Cancelled);
        }
        self.watch.progress(Phase::Read, self.seen, self.declared);
        for record in records.chunks_exact(self.record) {
            self.push(record)?;
        }
        Ok(())
    }

    fn push(&mut self, record: &[u8]) -> Result<(), Error> {
        self.seen += 1;
        let pulse = self.pulse(record);
        if pulse.is_withheld {
            return Ok(());
        }
        self.present[usize::from(pulse.class)] = true;
        if !self.is_wanted(&pulse) {
            return Ok(());
        }
        if self.points.len() as u64 == node::MAX_POINTS {
            return Err(self.malformed(node::too_many(node::MAX_POINTS + 1)));
        }
        let coordinate = |k: usize| {
            let at = 4 * k;
            let bytes = [record[at], record[at + 1], record[at + 2], record[at + 3]];
            self.axes[k].coordinate(i32::from_le_bytes(bytes))
        };
        let [x, y, z] = [0, 1, 2].map(coordinate);
        self.points.push(Point::new(x, y));
        self.z.push(z);
        self.classes.push(pulse.class);
        let intensity = u16::from_le_bytes([record[12], record[13]]);
        self.intensities.push(intensity);
        for (column, number) in self.returns.iter_mut().zip(pulse.returns) {
            column.push(number);
        }
        Ok(())
    }

    fn pulse(&self, record: &[u8]) -> Pulse {
        let (returns, flags) = (record[14], record[15]);
        match self.is_extended {
            true => Pulse {
                class: record[16],
                returns: [returns & 15, returns >> 4],
                is_withheld: flags & 4 != 0,
            },
            false => Pulse {
                class: flags & 31,
                returns: [returns & 7, returns >> 3 & 7],
                is_withheld: flags & 128 != 0,
            },
        }
    }

    /// Tells whether a record is one of those that are asked for; numbers that were never filled in, 0 of 0, are
    /// those of a pulse with a single return.
    fn is_wanted(&self, pulse: &Pulse) -> bool {
        let [number, all] = pulse.returns;
        let by_class = &self.options.classes;
        (by_class.is_empty() || by_class.contains(&pulse.class))
            && match self.options.returns {
                Returns::All => true,
                Returns::First => number <= 1,
                Returns::Last => number >= all,
                Returns::Single => all <= 1,
            }
    }

    /// Hands out the points.
    ///
    /// # Errors
    /// If none is left of those that there are.
    pub fn finish(self) -> Result<PointSet, Error> {
        self.watch.progress(Phase::Read, self.seen, self.declared);
        let there_are = self.present.iter().any(|&is| is);
        if self.points.is_empty() && there_are && self.chooses() {
            let classes = self.present.iter().enumerate();
            let classes = classes.filter(|(_, is)| **is).map(|(c, _)| c.to_string());
            let classes = classes.collect::<Vec<_>>().join(", ");
            return Err(self.malformed(Problem::Other(format!(
                "none of the points is of the classes and returns asked for; there are classes {classes}"
            ))));
        }
        let column = |name: &str, values: Vec<f64>| Attribute {
            name: name.to_owned(),
            values,
        };
        let mut attributes = vec![
            column("z", self.z),
            column("classification", doubles(self.classes)),
        ];
        let varies = |values: &[u8]| values.windows(2).any(|pair| pair[0] != pair[1]);
        if self.intensities.windows(2).any(|pair| pair[0] != pair[1]) {
            attributes.push(column("intensity", doubles(self.intensities)));
        }
        let names = ["return_number", "number_of_returns"];
        for (name, values) in names.into_iter().zip(self.returns) {
            if varies(&values) {
                attributes.push(column(name, doubles(values)));
            }
        }
        let mut points = self.points;
        points.shrink_to_fit();
        Ok(PointSet {
            points,
            attributes,
            ..PointSet::default()
        })
    }
}

fn doubles<T: Into<f64>>(values: Vec<T>) -> Vec<f64> {
    values.into_iter().map(Into::into).collect()
}
