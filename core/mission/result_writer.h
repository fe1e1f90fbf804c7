// The files that a mission leaves on the disk.
#pragma once

#include <string>

#include <QJsonObject>
#include <QString>
#include <QStringList>

#include "core/base/result.h"
#include "core/mission/scan_record.h"

namespace usar::mission {

/// USAR_Scan on the person's Desktop, or in the home folder where there is no Desktop.
QString defaultResultFolder();

/// Writes <stem>.bil and .hdr (float32, NoData), <stem>_height.png (16-bit, metadata inside) and its world file
/// _height.pgw, <stem>_picture.png (with the thesis's marks), <stem>.json (the summary, and under "map" and "marks"
/// what the files contain): the raw heights first, each under a temporary name, then renamed; never over an older scan.
/// The stem is USAR_Scan_<level>_<robot>_<number>, with the first free number. Returns the files' full paths.
/// Parts of the map that are too far away for one raster with the rest come as _far1.bil and .hdr, _far2 and so on.
/// Called off the GUI thread; several calls at a time, from several programs too, get numbers of their own.
/// An unwritable folder is an error that names it. So is an empty map; its summary is written all the same.
Result<QStringList> writeResults(const ScanRecord& record, const QJsonObject& summary, const QString& folder);

/// What the person should know of a map that is not in one piece; empty where it is.
std::string farPartsNotice(const ScanRecord& record);

} // namespace usar::mission
