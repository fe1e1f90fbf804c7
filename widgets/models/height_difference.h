// How the height maps of two runs differ, as a picture and in words.
#pragma once

#include <QImage>
#include <QString>

#include "core/mapping/raster_difference.h"

namespace usar::widgets {

/// Reads the heights that a mission left beside its summary (.json). An empty raster where there are none, or where
/// they are damaged: the summary itself can still be compared. Reads files, so call it outside of the GUI thread.
mapping::Raster readHeights(const QString& summary_path);

/// Cells where the second map is higher are orange, those where it is lower are blue, equal ones are gray; the full
/// color stands for `full_m`. What only one map knows is transparent. One pixel for a cell.
QImage differencePicture(const mapping::RasterDifference& difference, double full_m);

/// The difference that gets the full color: three times the usual one, but not less than five centimeters, so that
/// noise does not look like a wall.
double fullColorOf_m(const mapping::RasterDifference& difference);

/// "Second minus first: usual difference 0.08 m, largest 1.20 m; 12 cells only in the first, 3 only in the second"
QString differenceText(const mapping::RasterDifference& difference);

} // namespace usar::widgets
