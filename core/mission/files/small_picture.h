// The picture of a scan among its result files.
#pragma once

#include <QByteArray>
#include <QString>

namespace usar::mission {

/// True if this file of a result is the map as a picture, with the marks of the flight.
bool isMapPicture(const QString& file);

/// The picture in this file as a PNG whose longer side has at most `most_px` pixels; empty if the file cannot be read.
QByteArray smallPicture(const QString& file, int most_px);

} // namespace usar::mission
