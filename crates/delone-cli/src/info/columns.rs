//! Columns of numbers and markers, summed up.

use crate::words::{counted, measure};
use delone_io::Attribute;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt;

/// A column of numbers, and from where to where they go.
#[derive(Serialize)]
pub struct Column {
    name: String,
    count: usize,
    least: Option<f64>,
    largest: Option<f64>,
    /// How many there could be.
    #[serde(skip)]
    rows: usize,
}

impl From<&Attribute> for Column {
    fn from(Attribute { name, values }: &Attribute) -> Self {
        let numbers = || values.iter().copied().filter(|v| !v.is_nan());
        Self {
            name: name.clone(),
            count: numbers().count(),
            least: numbers().reduce(f64::min),
            largest: numbers().reduce(f64::max),
            rows: values.len(),
        }
    }
}

impl fmt::Display for Column {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: ", self.name)?;
        match (self.least, self.largest) {
            (Some(least), Some(largest)) => {
                write!(f, "{} to {}", measure(least), measure(largest))?
            }
            _ => write!(f, "no numbers")?,
        }
        match self.rows - self.count {
            0 => Ok(()),
            missing => write!(f, ", {} missing", counted(missing, "number", "numbers")),
        }
    }
}

/// Markers, and how often each is there.
#[derive(Serialize)]
pub struct Markers {
    total: usize,
    listed: Vec<(i32, usize)>,
}

impl Markers {
    pub fn of(markers: &[i32], limit: usize) -> Self {
        let mut counts: BTreeMap<i32, usize> = BTreeMap::new();
        for &marker in markers {
            *counts.entry(marker).or_default() += 1;
        }
        Self {
            total: counts.len(),
            listed: counts.into_iter().take(limit).collect(),
        }
    }
}

impl fmt::Display for Markers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, (marker, count)) in self.listed.iter().enumerate() {
            let comma = if i == 0 { "" } else { ", " };
            write!(f, "{comma}{marker} ({})", counted(*count, "time", "times"))?;
        }
        match self.total - self.listed.len() {
            0 => Ok(()),
            more => write!(f, " and {}", counted(more, "other", "others")),
        }
    }
}
