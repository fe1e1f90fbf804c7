// Maps in other formats, from a flight of the program `usar-mission` and afterwards by its verb `export`.
#include <cmath>
#include <cstring>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "core/mapping/raster_export.h"
#include "tests/suite/suite.h"

namespace tst_usar_export {

using namespace usar;

namespace {

struct Ended {
    int exit_code = -1;
    QByteArray err;
    QJsonObject summary;

    /// The path of the first file that ends so.
    QString file(const QString& suffix) const {
        for (const auto& value : summary["files"].toArray())
            if (value.toString().endsWith(suffix))
                return value.toString();
        return {};
    }
};

Ended run(const QStringList& arguments) {
    QProcess process;
    process.start(USAR_BINARY_DIR "/bin/usar-mission", arguments);
    process.waitForFinished(110000);
    const QByteArray out = process.readAllStandardOutput();
    return {process.exitCode(), process.readAllStandardError(),
            QJsonDocument::fromJson(out.trimmed().split('\n').last()).object()};
}

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class tst_UsarExport : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void theFlightLeavesWhatWasAskedFor();
    void theResultGivesTheSameHeights();
    void theRecordingGivesTheSameHeights();
    void thePointsOfFlightAndRecordingAreTheSame();
    void thePointsLieInTheKnownCells();
    void refusalsComeBeforeTheFlight();

private:
    QString path(const QString& name) const { return folder_.filePath(name); }

    QTemporaryDir folder_;
    Ended flight_;
    Ended recording_; ///< exported by theRecordingGivesTheSameHeights
};

void tst_UsarExport::initTestCase() {
    QFile file(path("mission.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{ \"name\": \"Small\", \"area\": { \"x\": -8, \"y\": -8, \"width\": 16, \"height\": 16 } }");
    file.close();
    flight_ = run({"run", path("mission.json"), "--export", "tif,asc,geojson,ply,las", "--out", path("out"), "--record",
                   path("flight.usarrec")});
    QVERIFY2(flight_.exit_code == 0, flight_.err);
}

void tst_UsarExport::theFlightLeavesWhatWasAskedFor() {
    for (const char* const suffix : {".bil", ".tif", ".asc", ".geojson", ".ply", ".las"})
        QVERIFY2(QFile::exists(flight_.file(suffix)), suffix);
}

void tst_UsarExport::theResultGivesTheSameHeights() {
    const Ended ended =
        run({"export", flight_.file(".json"), "--formats", "tif,asc,geojson", "--out", path("from_result")});
    QVERIFY2(ended.exit_code == 0, ended.err);
    for (const char* const suffix : {".tif", ".asc", ".geojson"})
        QVERIFY2(bytesOf(ended.file(suffix)) == bytesOf(flight_.file(suffix)), suffix);
}

void tst_UsarExport::theRecordingGivesTheSameHeights() {
    recording_ = run({"export", path("flight.usarrec"), "--out", path("from_recording")});
    QVERIFY2(recording_.exit_code == 0, recording_.err);
    QVERIFY(recording_.file(".tif").endsWith("/from_recording/flight.tif"));
    for (const char* const suffix : {".tif", ".asc", ".geojson"})
        QVERIFY2(bytesOf(recording_.file(suffix)) == bytesOf(flight_.file(suffix)), suffix);
}

void tst_UsarExport::thePointsOfFlightAndRecordingAreTheSame() {
    QVERIFY(bytesOf(flight_.file(".ply")).size() > 24 * 10'000);
    QVERIFY(bytesOf(recording_.file(".ply")) == bytesOf(flight_.file(".ply")));
    // All but the day on which it was written.
    QVERIFY(bytesOf(recording_.file(".las")).mid(94) == bytesOf(flight_.file(".las")).mid(94));
}

/// Each hit writes its cell, so no point is over an unknown one, and its time is within the flight.
void tst_UsarExport::thePointsLieInTheKnownCells() {
    const QByteArray ply = bytesOf(flight_.file(".ply"));
    auto raster = mapping::readBilHeader(bytesOf(flight_.file(".hdr")).toStdString());
    const QByteArray heights = bytesOf(flight_.file(".bil"));
    QVERIFY(raster && mapping::takeBilBytes(*raster, {heights.constData(), std::size_t(heights.size())}));
    const QByteArray word = "end_header\n";
    double last_s = 0.0;
    for (qsizetype at = ply.indexOf(word) + word.size(); at < ply.size(); at += 24) {
        float x_m = 0.0f, y_m = 0.0f, range_m = 0.0f;
        double time_s = 0.0;
        std::memcpy(&x_m, ply.constData() + at, 4);
        std::memcpy(&y_m, ply.constData() + at + 4, 4);
        std::memcpy(&time_s, ply.constData() + at + 12, 8);
        std::memcpy(&range_m, ply.constData() + at + 20, 4);
        const Vec2 place = (Vec2(double(x_m), double(y_m)) - raster->upper_left_center_m) / raster->cell_size_m;
        // A float may be on the other side of the border between two cells.
        const auto known = [&](double shift) {
            const auto column = std::llround(place.x() + shift), row = std::llround(-place.y() + shift);
            return column >= 0 && row >= 0 && column < raster->columns && row < raster->rows &&
                   !std::isnan(raster->heights_m[std::size_t(row * raster->columns + column)]);
        };
        QVERIFY(known(0.0) || known(1e-4) || known(-1e-4));
        QVERIFY(range_m > 0.0f && range_m < 20.0f && time_s >= last_s);
        last_s = time_s;
    }
    const double landed_s = flight_.summary["duration_s"].toDouble();
    QVERIFY(last_s > 0.8 * landed_s && last_s <= landed_s); // As it sinks and turns, its scans are not used.
}

void tst_UsarExport::refusalsComeBeforeTheFlight() {
    const Ended ended = run({"run", path("mission.json"), "--export", "shp", "--out", path("never")});
    QCOMPARE(ended.exit_code, 2);
    QVERIFY2(ended.err.contains("--export shp: there is no format named shp"), ended.err);
    QVERIFY(!QFile::exists(path("never")));
}

USAR_TEST(tst_UsarExport)

} // namespace tst_usar_export

#include "tst_usar_export.moc"
