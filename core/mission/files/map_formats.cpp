#include "core/mission/files/map_formats.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>

#include <QDateTime>
#include <QDir>
#include <QFileInfo>

#include "core/mapping/contours.h"
#include "core/mapping/geotiff.h"
#include "core/mapping/scan_points.h"

namespace usar::mission {

namespace {

bool writeLasOfToday(std::span<const mapping::KeptScan> scans, const mapping::ByteSink& sink) {
    const QDate today = QDateTime::currentDateTimeUtc().date();
    return mapping::writeLas(
        scans, {static_cast<std::uint16_t>(today.dayOfYear()), static_cast<std::uint16_t>(today.year())}, sink);
}

constexpr std::array formats{
    MapFormat{"tif", "GeoTIFF", "heights as float32 in tiles, for GIS programs and GDAL", mapping::writeGeoTiff,
              nullptr},
    MapFormat{"asc", "ESRI ASCII grid", "heights as text, for GIS programs and GDAL", mapping::writeAsciiGrid, nullptr},
    MapFormat{"geojson", "GeoJSON", "contours with their elevation, for GIS programs", mapping::writeContours, nullptr},
    MapFormat{"ply", "PLY", "points with time and range, for CloudCompare and MeshLab", nullptr, mapping::writePly},
    MapFormat{"las", "LAS 1.2", "points with time and range, for CloudCompare, QGIS and PDAL", nullptr,
              writeLasOfToday},
};

QStringList knownIds() {
    QStringList ids;
    for (const MapFormat& format : formats)
        ids << format.id;
    return ids;
}

/// A file of a format: how it ends, and what writes it.
struct Piece {
    QString ending;
    std::function<bool(const mapping::ByteSink&)> write;
};

std::vector<Piece> piecesOf(const FormatList& wanted, const ScanRecord& record) {
    std::vector<Piece> pieces;
    for (const MapFormat* format : wanted) {
        const QString ending = QString(".") + format->id;
        if (format->write_points) {
            pieces.push_back(
                {ending, [format, &record](const auto& sink) { return format->write_points(*record.scans, sink); }});
            continue;
        }
        const auto addHeights = [&](const QString& part, const mapping::Raster& raster) {
            pieces.push_back(
                {part + ending, [format, &raster](const auto& sink) { return format->write_heights(raster, sink); }});
        };
        addHeights({}, record.raster);
        for (std::size_t i = 0; i < record.far_rasters.size(); ++i)
            addHeights(QString("_far%1").arg(i + 1), record.far_rasters[i]);
    }
    return pieces;
}

} // namespace

std::span<const MapFormat> mapFormats() {
    return formats;
}

Result<FormatList> readFormatList(const QString& text, const QString& option) {
    FormatList list;
    for (const QString& word : text.split(',')) {
        const QString id = word.trimmed().toLower();
        const auto found = std::ranges::find_if(formats, [&](const MapFormat& format) { return id == format.id; });
        if (found == formats.end())
            return failure(id.isEmpty() ? "the name of a format is missing"
                                        : "there is no format named " + id.toStdString(),
                           (option + ' ' + text).toStdString(),
                           "Formats are " + knownIds().join(", ").toStdString() + "; for example " +
                               option.toStdString() + " tif,asc");
        if (!std::ranges::count(list, &*found))
            list.push_back(&*found);
    }
    return list;
}

bool needPoints(const FormatList& list) {
    return std::ranges::any_of(list, [](const MapFormat* format) { return format->write_points != nullptr; });
}

FormatList withoutPoints(const FormatList& list) {
    FormatList heights;
    std::ranges::copy_if(list, std::back_inserter(heights),
                         [](const MapFormat* format) { return format->write_points == nullptr; });
    return heights;
}

Result<void> checkPoints(const FormatList& list, const ScanRecord& record) {
    const auto points = std::ranges::find_if(list, [](const MapFormat* format) { return format->write_points; });
    if (points == list.end() || record.scans)
        return {};
    return failure("there are no points, only heights", (*points)->id,
                   "Export it from the recording of the flight (.usarrec), or name it when the mission is flown; after "
                   "some 14 hours of flight the points are dropped");
}

QStringList formatNotes() {
    QStringList notes;
    for (const MapFormat& format : formats)
        notes << QString("%1: %2, %3.").arg(format.id, format.title, format.use);
    return notes;
}

void writeFormats(FileSet& files, const FormatList& wanted, const ScanRecord& record) {
    for (const Piece& piece : piecesOf(wanted, record)) {
        if (files.stopped() || files.files().contains(files.pathOf(piece.ending)))
            continue;
        files.stream(piece.ending, piece.write);
    }
}

Result<QStringList> exportMap(const ScanRecord& record, const FormatList& wanted, const QString& folder,
                              const QString& stem, const std::stop_token& stop) {
    if (record.raster.empty())
        return failure("nothing was scanned, so there is no map to export", folder.toStdString(),
                       "Let the robot scan the area first");
    if (const auto possible = checkPoints(wanted, record); !possible)
        return tl::unexpected(possible.error());
    return withLockedFolder(folder, stop, [&]() -> Result<QStringList> {
        FileSet files(QDir(folder).absolutePath(), stem.isEmpty() ? freeStem(folder, record) : stem, stop);
        for (const Piece& piece : piecesOf(wanted, record))
            if (const QString path = files.pathOf(piece.ending); QFileInfo::exists(path))
                return failure("there is a file of this name already, and it is left alone", path.toStdString(),
                               "Choose another folder, or other formats");
        writeFormats(files, wanted, record);
        if (files.error())
            return tl::unexpected(*files.error());
        return files.files();
    });
}

} // namespace usar::mission
