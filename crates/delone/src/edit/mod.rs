//! Live editing: insert, remove and move vertices, add and remove constraints, canonical at every moment.
