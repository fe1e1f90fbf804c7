#include "core/mission/files/result_writer.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImageWriter>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLockFile>
#include <QRegularExpression>
#include <QSaveFile>
#include <QStandardPaths>

#include "core/agent/mark_style.h"
#include "core/base/numbers.h"
#include "core/mission/files/map_picture.h"

namespace usar::mission {

namespace {

const QString folder_mend = "Choose another folder, or make this one writable and save again";

QString fileNamePart(const std::string& name, const QString& fallback) {
    static const QRegularExpression unwanted("[^A-Za-z0-9-]+");
    const QString part = QString::fromStdString(name).replace(unwanted, "-").left(40);
    return part.contains(QRegularExpression("[A-Za-z0-9]")) ? part : fallback;
}

/// Returns the first stem with which no file in the folder begins.
QString freeStem(const QDir& folder, const ScanRecord& record) {
    const QString base =
        QString("USAR_Scan_%1_%2").arg(fileNamePart(record.level, "map"), fileNamePart(record.robot_name, "robot"));
    for (int number = 1;; ++number) {
        const QString stem = QString("%1_%2").arg(base).arg(number, 3, 10, QChar('0'));
        if (folder.entryList({stem + ".*", stem + "_*"}, QDir::Files | QDir::Hidden).isEmpty())
            return stem;
    }
}

Error cancelledIn(const QString& folder) {
    return {"saving was cancelled, and nothing of it is left in the folder", folder.toStdString(),
            "The scan is still in memory: save it whenever you like"};
}

/// A file that takes nothing more once a stop is requested.
class StoppableFile : public QSaveFile {
public:
    StoppableFile(const QString& path, std::stop_token stop) : QSaveFile(path), stop_(std::move(stop)) {}

protected:
    qint64 writeData(const char* data, qint64 size) override {
        return stop_.stop_requested() ? -1 : QSaveFile::writeData(data, size);
    }

private:
    std::stop_token stop_;
};

/// Writes the files of one scan; stops at the first failure, or when it is told to.
class Writing {
public:
    Writing(QString folder, QString stem, std::stop_token stop)
        : folder_(std::move(folder))
        , stem_(std::move(stem))
        , stop_(std::move(stop)) {}

    void bytes(const QString& ending, const char* data, qsizetype size) {
        save(ending, [&](QSaveFile& file) {
            qsizetype done = 0;
            while (done < size) {
                const qint64 part = file.write(data + done, std::min(size - done, part_size));
                if (part <= 0)
                    return false;
                done += part;
            }
            return true;
        });
    }
    void bytes(const QString& ending, const QByteArray& data) { bytes(ending, data.constData(), data.size()); }

    void image(const QString& ending, const QImage& picture) {
        save(ending, [&](QSaveFile& file) {
            QImageWriter writer(&file, "png");
            writer.setQuality(fast_compression);
            return writer.write(picture);
        });
    }

    QString pathOf(const QString& ending) const { return QDir(folder_).filePath(stem_ + ending); }
    const QStringList& files() const { return files_; }
    const std::optional<Error>& error() const { return error_; }
    /// True after an error or a request to stop; what comes next need not even be prepared.
    bool stopped() {
        if (!error_ && stop_.stop_requested()) {
            std::ranges::for_each(std::exchange(files_, {}), [](const QString& path) { QFile::remove(path); });
            error_ = cancelledIn(folder_);
        }
        return error_.has_value();
    }

private:
    /// Quality on Qt's scale, which means zlib level 3; the default takes three times as long to save a tenth of the
    /// size.
    static constexpr int fast_compression = 66;

    /// Bytes between two looks at whether to stop.
    static constexpr qsizetype part_size = qsizetype(1) << 20;

    template <class Write>
    void save(const QString& ending, const Write& write) {
        if (stopped())
            return;
        const QString path = pathOf(ending);
        StoppableFile file(path, stop_);
        if (file.open(QIODevice::WriteOnly) && write(file) && file.commit())
            files_ << path;
        else if (!stopped())
            error_ = Error{"cannot write: " + file.errorString().toStdString(), path.toStdString(),
                           folder_mend.toStdString()};
    }

    QString folder_;
    QString stem_;
    std::stop_token stop_;
    QStringList files_;
    std::optional<Error> error_;
};

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

void writeRaw(Writing& writing, const QString& part, const mapping::Raster& raster, const QString& ending = ".bil") {
    const std::vector<char> heights = mapping::bilBytes(raster);
    writing.bytes(part + ending, heights.data(), static_cast<qsizetype>(heights.size()));
    writing.bytes(part + ".hdr", QByteArray::fromStdString(mapping::bilHeader(raster)));
}

/// The same heights as text, for programs that read no raw files; not for huge maps.
void writeText(Writing& writing, const mapping::Raster& raster) {
    if (raster.columns * raster.rows > mapping::most_text_cells)
        return;
    writing.bytes(".asc", QByteArray::fromStdString(mapping::asciiGrid(raster)));
    writing.bytes(".xyz", QByteArray::fromStdString(mapping::xyzPoints(raster)));
}

void writeHeightImage(Writing& writing, const ScanRecord& record) {
    QImage height_image = heightImage(record.raster);
    for (const auto& [key, value] : metadataOf(record))
        height_image.setText(key, value);
    writing.image("_height.png", height_image);
    writing.bytes("_height.pgw", worldFile(record.raster));
}

void writePicture(Writing& writing, const ScanRecord& record, const mapping::HeightLook& look) {
    writing.image(mapping::picture_ending, mapPicture(record, look));
    writing.image("_legend.png", legendPicture(record, look));
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

void writeAdjustment(Writing& writing, const MapAdjustment& adjustment) {
    writing.bytes("_path.csv", correctedPath(adjustment.path));
    if (!writing.stopped())
        writeRaw(writing, "_deviation", adjustment.deviation, ".flt"); // A .bil is a map of heights.
}

void writeMap(Writing& writing, const ScanRecord& record, const mapping::HeightLook& look) {
    writeRaw(writing, {}, record.raster);
    if (!writing.stopped())
        writeText(writing, record.raster);
    if (record.adjustment && !record.adjustment->path.empty() && !writing.stopped())
        writeAdjustment(writing, *record.adjustment);
    for (std::size_t i = 0; i < record.far_rasters.size() && !writing.stopped(); ++i)
        writeRaw(writing, QString("_far%1").arg(i + 1), record.far_rasters[i]);
    if (!writing.stopped())
        writeHeightImage(writing, record);
    if (!writing.stopped())
        writePicture(writing, record, look);
}

/// Waits up to a minute while others save into the same folder.
bool waitFor(QLockFile& lock, const std::stop_token& stop) {
    constexpr int longest_ms = 60'000, part_ms = 100;
    for (int waited_ms = 0; waited_ms < longest_ms && !stop.stop_requested(); waited_ms += part_ms)
        if (lock.tryLock(part_ms) || lock.error() != QLockFile::LockFailedError)
            break;
    return lock.isLocked();
}

} // namespace

QString defaultResultFolder() {
    const QString desktop = QStandardPaths::writableLocation(QStandardPaths::DesktopLocation);
    return QDir(!desktop.isEmpty() && QDir(desktop).exists() ? desktop : QDir::homePath()).filePath("USAR_Scan");
}

Result<QStringList> writeResults(const ScanRecord& record, const QJsonObject& summary, const QString& folder,
                                 const mapping::HeightLook& look, const std::stop_token& stop) {
    if (folder.isEmpty() || !QDir().mkpath(folder))
        return failure("cannot create the folder for the results", folder.toStdString(), folder_mend.toStdString());
    // Held until everything is written: two scans that end at the same time must not take the same free number.
    QLockFile lock(QDir(folder).filePath(".usar_scan.lock"));
    lock.setStaleLockTime(0);
    if (!waitFor(lock, stop) && stop.stop_requested())
        return tl::unexpected(cancelledIn(folder));
    if (!lock.isLocked())
        return failure(lock.error() == QLockFile::LockFailedError ? "another program is still saving into the folder"
                                                                  : "cannot write into the folder",
                       folder.toStdString(), folder_mend.toStdString());

    Writing writing(QDir(folder).absolutePath(), freeStem(QDir(folder), record), stop);
    if (!record.raster.empty())
        writeMap(writing, record, look);
    writing.bytes(".json", summaryBytes(record, summary, writing.files() + QStringList{writing.pathOf(".json")}));
    if (writing.error())
        return tl::unexpected(*writing.error());
    if (record.raster.empty())
        return failure("nothing was scanned, so there is no map to save", folder.toStdString(),
                       "let the robot scan the area first; the summary is in " +
                           QFileInfo(writing.pathOf(".json")).fileName().toStdString());
    return writing.files();
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
