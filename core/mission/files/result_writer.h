// Writes the result files of a mission, and names new recordings.
#pragma once

#include <stop_token>
#include <string>

#include <QDateTime>
#include <QJsonObject>
#include <QString>
#include <QStringList>

#include "core/base/result.h"
#include "core/mapping/height_look.h"
#include "core/mission/files/map_formats.h"
#include "core/mission/files/scan_record.h"

namespace usar::mission {

/// Which runs leave files with their map.
enum class ResultFiles { Always, IfFailed, Never };

/// Folder USAR_Scan on the user's Desktop, or in the home folder if there is no Desktop.
QString defaultResultFolder();

/// Writes `<stem>.bil` and .hdr (float32, NoData), .asc and .xyz (text, unless the map is huge), `<stem>_height.png`
/// (16-bit, metadata inside) and its world file _height.pgw, `<stem>_picture.png` (with the marks of the thesis), its
/// legend alone, `<stem>_legend.png`, the map in perspective, `<stem>_3d.png`, and `<stem>.json` (`summary`, and under
/// "map" and "marks" what the files contain). The raw heights come first; each file is written under a temporary name
/// and then renamed; older scans are never overwritten. The stem is `USAR_Scan_LEVEL_ROBOT_NUMBER`, with the first free
/// number. A map that was adjusted also has `<stem>_path.csv` (the path as it was estimated and as it was corrected,
/// with its standard deviation) and _deviation.flt and .hdr (what the heights owe to that, in meters, float32 as the
/// heights). Where holes of less than a square meter are filled in (mapping::withHolesFilled), `<stem>_filled.flt` has
/// these heights, too, and _filled_mask.flt tells which they are (1; measured ones: 0); both have a .hdr. Parts of the
/// map that are too far away to be in one raster with the rest are written as _far1.bil and
/// .hdr, _far2 and so on. Each of `formats` is written besides, as writeFormats does.
/// Returns the full paths of the files. To be called outside the GUI thread; concurrent calls, also from several
/// programs, get numbers of their own. An unwritable folder is an error that names it. An empty map is an error, too,
/// but its summary is still written. `look` is that of the picture. When `stop` is requested, in any thread, it removes
/// the files that it has written, and returns an error; a request after the last file comes too late.
Result<QStringList> writeResults(const ScanRecord& record, const QJsonObject& summary, const QString& folder,
                                 const mapping::HeightLook& look = {}, const std::stop_token& stop = {},
                                 const FormatList& formats = {});

/// Sentences for the user about a map that does not fit into one raster; empty if it does.
std::string farPartsNotice(const ScanRecord& record);

/// Returns the path in `folder` of a file that does not exist yet: "R1_2026-11-21_18-21-29.usarrec", with a number
/// appended to the name if that file exists. Characters of the robot's name that are unsafe in a file name become
/// underscores.
QString newRecordingIn(const QString& folder, const QString& robot_name, const QDateTime& now);

} // namespace usar::mission
