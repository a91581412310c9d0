// Which format text has that somebody pastes.

/** Names text as a file of its format would be named: GeoJSON, well-known text, or a table. */
export function nameOfText(text: string): string {
  const begin = text.trimStart();
  if (/^[{[]/.test(begin)) return "text.geojson";
  if (/^(SRID|POINT|LINESTRING|POLYGON|MULTI|GEOMETRYCOLLECTION|TRIANGLE|TIN)/i.test(begin))
    return "text.wkt";
  return "text.csv";
}
