"""Makes the files of this folder, with the tools of others: see README.md."""

import pathlib
import subprocess

import duckdb
import geopandas
import numpy
import pandas
import polars
import pyarrow
import pyarrow.parquet
import shapely
from shapely.geometry import LineString, MultiPoint, MultiPolygon, Point, Polygon

# Points in several groups of rows, with a null, a text, a truth value, whole numbers and a date.
n = 60
i = numpy.arange(n)
table = pandas.DataFrame(
    {
        "name": [f"p{k}" for k in i],
        "lon": i * 0.1 + 0.3,
        "lat": numpy.sqrt(i),
        "count": (i * 1000003).astype("int64"),
        "small": i.astype("uint8"),
        "height": numpy.where(i == 7, numpy.nan, i / 8).astype("float32"),
        "wet": i % 3 == 0,
        "when": pandas.Timestamp("2020-01-01"),
        "marker": (i % 5 - 2).astype("int32"),
    }
)
for codec in ["none", "snappy", "gzip", "zstd", "lz4"]:
    compression = None if codec == "none" else codec
    table.to_parquet(f"pandas-{codec}.parquet", compression=compression, row_group_size=25)
polars.from_pandas(table).write_parquet("polars.parquet", compression="lz4", row_group_size=25)
connection = duckdb.connect()
connection.register("frame", table)
connection.sql("COPY (SELECT * FROM frame) TO 'duckdb.parquet' (FORMAT parquet, CODEC 'zstd')")

# What is small may mean much: a hundred million rows of one number.
same = pyarrow.array(numpy.zeros(1 << 20))
names = ["x", "y"]
with pyarrow.parquet.ParquetWriter(
    "bomb.parquet", pyarrow.schema([(name, pyarrow.float64()) for name in names]), store_schema=False,
    data_page_size=1 << 30, max_rows_per_page=1 << 30, write_statistics=False,
) as writer:
    ones = pyarrow.chunked_array([same] * 100)
    writer.write_table(pyarrow.table([ones, ones], names), row_group_size=100 << 20)

# Two fields, one with a hole, one of two parts; a way; places.
square = Polygon([(0, 0), (8, 0), (8, 8), (0, 8)], [[(2, 2), (4, 2), (3, 4)]])
parts = MultiPolygon(
    [Polygon([(10, 0), (12, 0), (12, 2)]), Polygon([(20, 0), (22, 0), (22, 2), (20, 2)])]
)
fields = geopandas.GeoDataFrame(
    {"marker": [7, -3], "yield": [1.5, 2.25], "crop": ["rye", "oat"]},
    geometry=[square, parts],
    crs="EPSG:4326",
)
contours = geopandas.GeoDataFrame(
    {"elev": [10.5, 20.0], "id": [4, 9]},
    geometry=[LineString([(0, 0), (1, 2), (3, 3)]), LineString([(0, 5), (4, 5)])],
    crs="EPSG:25832",
)
places = geopandas.GeoDataFrame(
    {"pop": [100, 250, 0], "rank": [1.5, None, -2.0], "name": ["a", "b", "c"]},
    geometry=[Point(1, 2, 3), Point(-0.5, 0.25, 4), Point(7, 8, 5)],
    crs="EPSG:4326",
)
for name, layer in [("fields", fields), ("contours", contours), ("places", places)]:
    layer.to_parquet(f"{name}.parquet")
    layer.to_file(f"{name}.geojson")
    # GDAL writes the shapefile.
    subprocess.run(["ogr2ogr", "-f", "ESRI Shapefile", f"{name}.shp", f"{name}.geojson"], check=True)
places.to_parquet("places-native.parquet", geometry_encoding="geoarrow")
subprocess.run(
    ["ogr2ogr", "-f", "ESRI Shapefile", "-dim", "XYZM", "measured.shp", "-nlt", "LINESTRINGZM",
     "-dialect", "sqlite", "-sql", "SELECT MakeLine(MakePointZM(0,0,1,10), MakePointZM(3,4,2,20)) AS geometry FROM contours LIMIT 1",
     "contours.geojson"],
    check=True,
)
# What PostGIS prints.
hexes = [shapely.to_wkb(shapely.set_srid(g, 4326), hex=True, include_srid=True) for g in
         [square, MultiPoint([(1, 1), (5, 5)]), LineString([(0, 0, 1), (8, 8, 2)])]]
with open("postgis.wkt", "w") as out:
    out.write("\n".join(hexes) + "\n")
# The index and the projection are not read.
for path in [*pathlib.Path().glob("*.shx"), *pathlib.Path().glob("*.prj")]:
    path.unlink()
