#include "core/mission/runs/export_source.h"

#include <utility>

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "core/mission/runs/recorded_scan.h"

namespace usar::mission {

namespace {

/// Reads the raw heights with this stem, which includes the folder.
Result<mapping::Raster> readHeights(const QString& stem) {
    QFile header(stem + ".hdr"), heights(stem + ".bil");
    for (QFile* file : {&header, &heights})
        if (!file->open(QIODevice::ReadOnly))
            return failure(file->errorString().toStdString(), file->fileName().toStdString(),
                           "A result is exported from its raw heights, so keep .bil and .hdr beside its summary");
    auto raster = mapping::readBilHeader(header.readAll().toStdString());
    const QByteArray bytes = raster ? heights.readAll() : QByteArray();
    if (!raster || !mapping::takeBilBytes(*raster, {bytes.constData(), static_cast<std::size_t>(bytes.size())}))
        return failure("the raw heights are damaged, or another program wrote them", heights.fileName().toStdString(),
                       "Export from the recording of the flight, or fly it again");
    return *std::move(raster);
}

Result<RecordedMap> readResult(const QString& stem) {
    auto raster = readHeights(stem);
    if (!raster)
        return tl::unexpected(raster.error());
    ScanRecord record;
    record.raster = *std::move(raster);
    for (int part = 1; QFileInfo::exists(QString("%1_far%2.bil").arg(stem).arg(part)); ++part) {
        auto far = readHeights(QString("%1_far%2").arg(stem).arg(part));
        if (!far)
            return tl::unexpected(far.error());
        record.far_rasters.push_back(*std::move(far));
    }
    return RecordedMap{std::move(record), {}};
}

} // namespace

Result<ExportSource> openExportSource(const QString& path, bool with_scans) {
    const QFileInfo file(path);
    if (!file.isFile())
        return failure("there is no such file", path.toStdString(), "Check the name");
    const QString stem = file.completeBaseName();
    const QString suffix = file.suffix().toLower();
    const bool recorded = suffix == "usarrec";
    if (!recorded && !QStringList{"json", "bil", "hdr"}.contains(suffix))
        return failure("this is neither a result nor a recording", path.toStdString(),
                       "Name the .json or .bil of a result, or a .usarrec");
    auto map = recorded ? readRecordedMap(path, with_scans) : readResult(file.dir().filePath(stem));
    if (!map)
        return tl::unexpected(map.error());
    if (map->record.raster.empty())
        return failure("nothing was scanned in this flight, so there is no map to export", path.toStdString(),
                       "Choose the recording of another robot or flight");
    return ExportSource{std::move(map->record), file.absolutePath(), stem, std::move(map->missing)};
}

} // namespace usar::mission
