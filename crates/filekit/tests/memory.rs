//! The counter of memory is exact to the byte.
//!
//! All threads count together, so this is a program without a harness: nobody else takes memory beside it.

use delone_filekit::Meter;
use std::hint::black_box;

fn main() {
    what_is_given_back_counts_too();
    what_grows_counts_twice_while_it_moves();
    what_was_taken_before_does_not_count();
}

fn what_is_given_back_counts_too() {
    let meter = Meter::start();
    drop(black_box(vec![1_u8; 1 << 22]));
    drop(black_box(vec![0_u8; 1 << 21]));
    assert_eq!(meter.peak(), 1 << 22);
}

fn what_grows_counts_twice_while_it_moves() {
    let mut bytes = black_box(Vec::<u8>::with_capacity(1 << 20));
    let meter = Meter::start();
    bytes.reserve_exact(1 << 22);
    assert_eq!(meter.peak(), 1 << 22);
    drop(black_box(bytes));
}

fn what_was_taken_before_does_not_count() {
    let before = black_box(vec![1_u8; 1 << 22]);
    let meter = Meter::start();
    assert_eq!(meter.peak(), 0);
    drop(before);
    drop(black_box(vec![1_u8; 1 << 21]));
    assert_eq!(meter.peak(), 0);
}
