#include "core/mission/files/result_writer.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QStandardPaths>

#include "core/agent/mark_style.h"
#include "core/base/numbers.h"
#include "core/mapping/hole_fill.h"
#include "core/mapping/relief/relief_scene.h"
#include "core/mission/files/file_set.h"
#include "core/mission/files/map_picture.h"
#include "core/mission/files/relief_picture.h"

namespace usar::mission {

namespace {

/// Marks except those of the path, of which there are thousands.
QJsonArray marksOf(const ScanRecord& record) {
    QJsonArray marks;
    for (const agent::MapMark& mark : record.marks) {
        if (mark.kind == agent::MarkKind::Path)
            continue;
        marks.append(QJsonObject{{"kind", QString::fromUtf8(agent::styleOf(mark.kind).word)},
                                 {"x_m", mark.position_in_map_m.x()},
                                 {"y_m", mark.position_in_map_m.y()},
                                 {"z_m", mark.position_in_map_m.z()},
                                 {"time_s", mark.time.count()}});
    }
    return marks;
}

QByteArray summaryBytes(const ScanRecord& record, QJsonObject summary, const QStringList& files) {
    QJsonObject map;
    for (const auto& [key, text] : metadataOf(record)) {
        bool is_number = false;
        const double value = text.toDouble(&is_number);
        map[key] = is_number && key.endsWith("_m") ? QJsonValue(value) : QJsonValue(text);
    }
    map["columns"] = double(record.raster.columns);
    map["rows"] = double(record.raster.rows);
    map["known_cells"] = double(record.raster.knownCellCount());
    map["far_parts"] = double(record.far_rasters.size());
    map["far_known_cells"] = double(knownCellCount(record) - record.raster.knownCellCount());
    map["cells_left_out"] = double(record.cells_left_out);
    map["no_data_m"] = double(mapping::no_data_m);
    const Rectangle& area = record.area_in_map;
    map["area"] = QJsonObject{
        {"x", area.min_m.x()}, {"y", area.min_m.y()}, {"width", area.width_m()}, {"height", area.height_m()}};
    QJsonArray names;
    for (const QString& file : files)
        names.append(QFileInfo(file).fileName());
    summary["map"] = map;
    summary["marks"] = marksOf(record);
    summary["files"] = names;
    return QJsonDocument(summary).toJson();
}

QByteArray worldFile(const mapping::Raster& raster) {
    return QString("%1\n0\n0\n-%1\n%2\n%3\n")
        .arg(numberText(raster.cell_size_m), numberText(raster.upper_left_center_m.x()),
             numberText(raster.upper_left_center_m.y()))
        .toLatin1();
}

void writeRaw(FileSet& files, const QString& part, const mapping::Raster& raster, const QString& ending = ".bil") {
    const std::vector<char> heights = mapping::bilBytes(raster);
    files.bytes(part + ending, heights.data(), static_cast<qsizetype>(heights.size()));
    files.bytes(part + ".hdr", QByteArray::fromStdString(mapping::bilHeader(raster)));
}

/// The same heights as text, for programs that read no raw files; not for huge maps.
void writeText(FileSet& files, const mapping::Raster& raster) {
    if (raster.columns * raster.rows > mapping::most_text_cells)
        return;
    files.bytes(".asc", QByteArray::fromStdString(mapping::asciiGrid(raster)));
    files.bytes(".xyz", QByteArray::fromStdString(mapping::xyzPoints(raster)));
}

void writeHeightImage(FileSet& files, const ScanRecord& record) {
    QImage height_image = heightImage(record.raster);
    for (const auto& [key, value] : metadataOf(record))
        height_image.setText(key, value);
    files.image("_height.png", height_image);
    files.bytes("_height.pgw", worldFile(record.raster));
}

void writePicture(FileSet& files, const ScanRecord& record, const mapping::HeightLook& look) {
    files.image(mapping::picture_ending, mapPicture(record, look));
    files.image("_legend.png", legendPicture(record, look));
    if (!files.stopped())
        files.image(mapping::relief_picture_ending, reliefPicture(record, look, files.stopToken()));
}

QByteArray correctedPath(const std::vector<CorrectedPoint>& path) {
    QByteArray text = "time_s,estimated_x_m,estimated_y_m,estimated_z_m,x_m,y_m,z_m,sigma_x_m,sigma_y_m,sigma_z_m\n";
    for (const CorrectedPoint& point : path) {
        text += QByteArray::number(point.time.count(), 'f', 2);
        for (const Vec3& place_m : {point.estimated_m, point.corrected_m, point.sigma_m})
            for (const double value_m : place_m)
                text += ',' + QByteArray::number(value_m, 'f', 3);
        text += '\n';
    }
    return text;
}

void writeAdjustment(FileSet& files, const MapAdjustment& adjustment) {
    files.bytes("_path.csv", correctedPath(adjustment.path));
    if (!files.stopped())
        writeRaw(files, "_deviation", adjustment.deviation, ".flt"); // A .bil is a map of heights.
}

/// The map itself stays as it was measured.
void writeFilled(FileSet& files, const mapping::Raster& raster) {
    const mapping::FilledRaster filled = mapping::withHolesFilled(raster);
    if (filled.filled_cells == 0)
        return;
    writeRaw(files, "_filled", filled.heights, ".flt"); // A .bil is a map of measured heights.
    writeRaw(files, "_filled_mask", filled.mask, ".flt");
}

void writeMap(FileSet& files, const ScanRecord& record, const mapping::HeightLook& look, const FormatList& formats) {
    writeRaw(files, {}, record.raster);
    if (!files.stopped())
        writeText(files, record.raster);
    if (!files.stopped())
        writeFilled(files, record.raster);
    if (record.adjustment && !record.adjustment->path.empty() && !files.stopped())
        writeAdjustment(files, *record.adjustment);
    for (std::size_t i = 0; i < record.far_rasters.size() && !files.stopped(); ++i)
        writeRaw(files, QString("_far%1").arg(i + 1), record.far_rasters[i]);
    if (!files.stopped())
        writeHeightImage(files, record);
    if (!files.stopped())
        writePicture(files, record, look);
    writeFormats(files, formats, record);
}

} // namespace

QString defaultResultFolder() {
    const QString desktop = QStandardPaths::writableLocation(QStandardPaths::DesktopLocation);
    return QDir(!desktop.isEmpty() && QDir(desktop).exists() ? desktop : QDir::homePath()).filePath("USAR_Scan");
}

Result<QStringList> writeResults(const ScanRecord& record, const QJsonObject& summary, const QString& folder,
                                 const mapping::HeightLook& look, const std::stop_token& stop,
                                 const FormatList& formats) {
    return withLockedFolder(folder, stop, [&]() -> Result<QStringList> {
        FileSet files(QDir(folder).absolutePath(), freeStem(folder, record), stop);
        if (!record.raster.empty())
            writeMap(files, record, look, formats);
        files.bytes(".json", summaryBytes(record, summary, files.files() + QStringList{files.pathOf(".json")}));
        if (files.error())
            return tl::unexpected(*files.error());
        if (record.raster.empty())
            return failure("nothing was scanned, so there is no map to save", folder.toStdString(),
                           "let the robot scan the area first; the summary is in " +
                               QFileInfo(files.pathOf(".json")).fileName().toStdString());
        return files.files();
    });
}

std::string farPartsNotice(const ScanRecord& record) {
    if (record.far_rasters.empty())
        return {};
    const std::size_t far_cells = knownCellCount(record) - record.raster.knownCellCount();
    const double cell_m = record.raster.cell_size_m;
    std::string text = "Part of the map is too far from the rest for one picture, which shows the middle " +
                       fixed(double(record.raster.columns) * cell_m, 0) + " m x " +
                       fixed(double(record.raster.rows) * cell_m, 0) + " m: " + std::to_string(far_cells) +
                       " cells in " + std::to_string(record.far_rasters.size()) +
                       " other places are saved as separate raw heights (_far1.bil and so on).";
    if (record.cells_left_out > 0)
        text += " " + std::to_string(record.cells_left_out) + " more cells, in still other places, are not saved.";
    return text + " Was a position garbled? If the area is really that large, choose larger cells.";
}

QString newRecordingIn(const QString& folder, const QString& robot_name, const QDateTime& now) {
    QString safe = robot_name;
    for (QChar& c : safe)
        if (!c.isLetterOrNumber() && c != '-' && c != '_')
            c = '_';
    const QString stem = safe + '_' + now.toString("yyyy-MM-dd_HH-mm-ss");
    QString name = stem;
    for (int number = 2; QFileInfo::exists(QDir(folder).filePath(name + ".usarrec")); ++number)
        name = stem + '_' + QString::number(number);
    return QDir(folder).filePath(name + ".usarrec");
}

} // namespace usar::mission
