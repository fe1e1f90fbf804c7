// Recordings exported as MCAP: topics, times and frames, damaged recordings, and targets that cannot be written.
#include <cstring>

#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include "core/agent/published_text.h"
#include "core/link/recording_format.h"
#include "core/mission/runs/recorded_plan.h"
#include "core/mission/runs/recorded_scan.h"
#include "core/mission/runs/recording_mcap.h"
#include "tests/doubles/mcap_file.h"
#include "tests/doubles/plain_recording.h"
#include "tests/doubles/plan_trace.h"
#include "tests/doubles/test_files.h"
#include "tests/suite/suite.h"

namespace tst_recording_mcap {

using namespace usar;
using namespace usar::mission;
using link::RecordKind;

namespace {

/// A recording in memory, whose records are 10 ms apart.
class Tape {
public:
    Tape() {
        doubles::appendOldHead(bytes);
        add({.kind = RecordKind::Start, .bytes = "robot: R 1\ncell_size_m: 0.5\n"});
        add({.kind = RecordKind::Opened, .bytes = "h:1"});
    }
    void in(const std::string& line) {
        add({.kind = RecordKind::In, .bytes = line + "\r\n"});
        ++lines_;
    }
    void note(const std::string& name, const std::string& text) {
        add({.kind = RecordKind::Note, .name = name, .bytes = text});
    }
    void publish(const agent::Published& value) {
        std::string text;
        agent::appendText(text, value);
        note("published", text);
    }
    void sent(const std::string& command) {
        add({.kind = RecordKind::Out,
             .trigger = {lines_},
             .name = "airrobot/cpp: scanning",
             .bytes = command + "\r\n"});
    }
    void add(link::Record record) {
        record.time = std::chrono::milliseconds(10) * count_++;
        record.line = {lines_};
        doubles::appendPlain(bytes, record);
    }
    std::uint64_t lines() const { return lines_; }

    std::string bytes;

private:
    int count_ = 0;
    std::uint64_t lines_ = 0;
};

/// A flight over level ground at 0 m, in an altitude of 5 m, with a scan of 61 beams every half a meter.
Tape flight(int scans) {
    Tape tape;
    tape.in("STA {Type AerialVehicle} {Time 20.0} {Battery 1000}");
    tape.in("GEO {Type RangeScanner} {Name S 1 Location 0,0,0 Orientation 0,-1.5707963,0 Mount HARD}");
    tape.in("CONF {Type RangeScanner} {Name S 1} {MaxRange 20.0} {MinRange 0.1} {Resolution 0.02} {Fov 1.2}");
    for (int scan = 0; scan < scans; ++scan) {
        const std::string time = std::to_string(20.0 + 0.2 * scan);
        std::string ranges;
        for (int beam = -30; beam <= 30; ++beam)
            ranges += (ranges.empty() ? "" : ",") + std::to_string(5.0 / std::cos(0.02 * beam));
        tape.in("STA {Type AerialVehicle} {Time " + time + "} {Battery 1000}");
        tape.in("SEN {Time " + time + "} {Type RangeScanner} {Name S 1} {Resolution 0.02} {FOV 1.2} {Range " + ranges +
                "}");
        const Pose base_in_map{.position_m = {0.5 * scan, 0.0, 5.0}};
        tape.publish(agent::PoseEstimate{Seconds{20.0 + 0.2 * scan}, base_in_map});
        tape.publish(agent::ScanPlacement{{tape.lines()}, base_in_map * Pose{.pitch_rad = pi / 2.0}});
    }
    return tape;
}

} // namespace

class tst_RecordingMcap : public QObject {
    Q_OBJECT
private slots:
    void linesBecomeMessages_data();
    void linesBecomeMessages();
    void aBehaviorsPoseComesBeforeThoseOfSensors();
    void theInsComesBeforeTheTruth();
    void commandsTellTheirCause();
    void theLogTellsWhatHappened();
    void aServerThatBeginsAgainGoesOnInTime();
    void stripsBecomeADepthImage();
    void aPlansActivePartsAreTold();
    void theMapIsThatOfTheRecording();
    void mapsAreAtMostHalfOfTheFile();
    void aTornRecordingIsExportedAsFarAsItGoes();
    void aGarbledRecordingIsExportedAroundTheDamage();
    void manyTopicsAreCutOff();
    void refusalsNameTheFileAndTheMend_data();
    void refusalsNameTheFileAndTheMend();
    void aCancelledExportLeavesNothing();
    void nothingIsBegunAfterACancel();
    void anExistingFileIsReplacedOnlyOnRequest();
    void theRecordingItselfIsLeftAlone();

private:
    QString path(const char* name) const { return folder_.filePath(name); }
    doubles::McapFile exported(const std::string& tape, std::string* complaint = nullptr);

    QTemporaryDir folder_;
};

doubles::McapFile tst_RecordingMcap::exported(const std::string& tape, std::string* complaint) {
    doubles::writeAll(doubles::pathOf(folder_) / "a.usarrec", tape);
    const auto summary = recordingToMcapFile(path("a.usarrec"), path("a.mcap"), true);
    std::string trouble = summary ? "" : summary.error().text();
    const auto file = doubles::readMcap(doubles::readAll(doubles::pathOf(folder_) / "a.mcap"), trouble);
    if (!summary || !file || summary->messages != file->messages.size()) {
        QTest::qFail(trouble.c_str(), __FILE__, __LINE__);
        return {};
    }
    if (complaint)
        *complaint = summary->complaint;
    return *file;
}

void tst_RecordingMcap::linesBecomeMessages_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("topic");
    QTest::addColumn<QString>("schema");
    QTest::addColumn<QString>("part"); ///< of the JSON
    QTest::addColumn<double>("published");
    QTest::newRow("ground truth, with z and yaw turned over")
        << "SEN {Time 7.5} {Type GroundTruth} {Name GT} {Location 1,2,-3} {Orientation 0,0,0}"
        << "/R_1/pose/GT"
        << "foxglove.PoseInFrame"
        << R"("frame_id":"map","pose":{"position":{"x":1,"y":-2,"z":3},"orientation":{"x":0,"y":0,"z":0,"w":1}})"
        << 7.5;
    QTest::newRow("the INS has no time of its own") << "SEN {Type INS} {Name INS} {Location 1,2,-3} {Orientation 0,0,0}"
                                                    << "/R_1/pose/INS"
                                                    << "foxglove.PoseInFrame"
                                                    << R"("position":{"x":1,"y":-2,"z":3})" << 8.0;
    QTest::newRow("odometry has a frame of its own") << "SEN {Type Odometry} {Name O} {Pose 1,2,0}"
                                                     << "/R_1/pose/O"
                                                     << "foxglove.PoseInFrame"
                                                     << R"("frame_id":"R_1/start")" << 8.0;
    QTest::newRow("the robot's pose is a transform, too")
        << "SEN {Type INS} {Name INS} {Location 1,2,-3} {Orientation 0,0,0}"
        << "/R_1/transform"
        << "foxglove.FrameTransform"
        << R"("parent_frame_id":"map","child_frame_id":"R_1/base","translation":{"x":1,"y":-2,"z":3})" << 8.0;
    QTest::newRow("a sonar") << "SEN {Time 7.75} {Type Sonar} {Name F1 Range 4.5} {Name F2 Range 2.25}"
                             << "/R_1/range/F2"
                             << "usar.Range"
                             << R"("frame_id":"R_1/F2","range_m":2.25})" << 7.75;
    QTest::newRow("an infrared sensor") << "SEN {Time 7.75} {Type IR} {Name I Range 0.5}"
                                        << "/R_1/range/I"
                                        << "usar.Range"
                                        << R"("range_m":0.5})" << 7.75;
    QTest::newRow("a scan, and a beam without a number")
        << "SEN {Time 8.0} {Type RangeScanner} {Name S/1} {Resolution 0.5} {FOV 1} {Range 1,nan,3}"
        << "/R_1/scan/S_1"
        << "foxglove.LaserScan"
        << R"("start_angle":-0.5,"end_angle":0.5,"ranges":[1,-1,3],"intensities":[]})" << 8.0;
    QTest::newRow("a mount")
        << "GEO {Type Sonar} {Name F1 Location 1,2,3 Orientation 0,0,0 Mount HARD}"
        << "/R_1/mount/F1"
        << "foxglove.FrameTransform"
        << R"("parent_frame_id":"R_1/base","child_frame_id":"R_1/F1","translation":{"x":1,"y":-2,"z":-3})" << 8.0;
    QTest::newRow("a mount on another part")
        << "GEO {Type Camera} {Name C Location 0,0,0 Orientation 0,0,0 Mount Pan_Link1}"
        << "/R_1/mount/C"
        << "foxglove.FrameTransform"
        << R"("parent_frame_id":"R_1/Pan_Link1","child_frame_id":"R_1/C")" << 8.0;
}

void tst_RecordingMcap::linesBecomeMessages() {
    QFETCH(QString, line);
    QFETCH(QString, topic);
    QFETCH(QString, schema);
    QFETCH(QString, part);
    QFETCH(double, published);
    Tape tape;
    tape.in("STA {Time 8.0} {Battery 1000}");
    tape.in(line.toStdString());
    const auto file = exported(tape.bytes);
    const auto found = file.of(topic.toStdString());
    QCOMPARE(found.size(), std::size_t(1));
    QCOMPARE(QString::fromStdString(found.front().schema), schema);
    QVERIFY2(found.front().data.find(part.toStdString()) != std::string::npos, found.front().data.c_str());
    QCOMPARE(found.front().published_ns, static_cast<std::uint64_t>(published * 1e9));
    QCOMPARE(found.front().logged_ns, std::uint64_t(8'000'000'000));
    const QJsonObject time = found.front().json()["timestamp"].toObject();
    QCOMPARE(time["sec"].toDouble() + time["nsec"].toDouble() * 1e-9, published);
    QCOMPARE(file.messages.front().logged_ns, std::uint64_t(8'000'000'000)); // Also what came before the first time.
}

void tst_RecordingMcap::aBehaviorsPoseComesBeforeThoseOfSensors() {
    Tape tape;
    const std::string ins = "SEN {Type INS} {Name INS} {Location 1,0,0} {Orientation 0,0,0}";
    tape.in(ins);
    tape.publish(agent::PoseEstimate{Seconds{0.0}, {.position_m = {2, 0, 0}}});
    tape.in(ins);
    tape.note("finished", "1 done");
    tape.in(ins);
    QStringList moves;
    for (const auto& message : exported(tape.bytes).of("/R_1/transform"))
        moves << QString::number(message.json()["translation"].toObject()["x"].toDouble());
    QCOMPARE(moves.join(' '), QString("1 2 1"));
}

void tst_RecordingMcap::theInsComesBeforeTheTruth() {
    Tape tape;
    for (int turn = 0; turn < 2; ++turn) {
        tape.in("SEN {Type GroundTruth} {Name GT} {Location 3,0,0} {Orientation 0,0,0}");
        tape.in("SEN {Type INS} {Name INS} {Location 1,0,0} {Orientation 0,0,0}");
    }
    QStringList moves;
    for (const auto& message : exported(tape.bytes).of("/R_1/pose"))
        moves << QString::number(message.json()["pose"].toObject()["position"].toObject()["x"].toDouble());
    QCOMPARE(moves.join(' '), QString("3 1 1"));
}

void tst_RecordingMcap::commandsTellTheirCause() {
    Tape tape;
    tape.in("STA {Time 8.0} {Battery 1000}");
    tape.sent("DRIVE {Left 1} {Right 1}");
    const auto found = exported(tape.bytes).of("/R_1/command");
    QCOMPARE(found.size(), std::size_t(1));
    const QJsonObject json = found.front().json();
    QCOMPARE(json["text"].toString(), QString("DRIVE {Left 1} {Right 1}"));
    QCOMPARE(json["source"].toString(), QString("airrobot/cpp: scanning"));
    QCOMPARE(json["trigger_line"].toInt(), 1);
}

void tst_RecordingMcap::theLogTellsWhatHappened() {
    Tape tape;
    tape.in("STA {Time 8.0} {Battery 1000}");
    tape.note("behavior", "airrobot/cpp\tR1\t0 0 3 4");
    tape.publish(agent::BehaviorEvent{Severity::Warning, "low battery – \"soon\""});
    tape.note("fault", "wind of 3 m/s");
    tape.in("SEN {Time 8.0} {Type GroundTruth} {Name GT} {Location 1,2} {Orientation 0,0,0}");
    tape.note("finished", "0 Landed on request.");
    tape.add({.kind = RecordKind::Closed, .bytes = "the server is gone"});
    QStringList log;
    for (const auto& message : exported(tape.bytes).of("/log")) {
        const QJsonObject json = message.json();
        log << QString("%1 %2: %3").arg(json["level"].toInt()).arg(json["name"].toString(), json["message"].toString());
        QCOMPARE(json.keys().join(' '), QString("file level line message name timestamp"));
    }
    QCOMPARE(log.size(), 8);
    QCOMPARE(log[0], QString("2 session: connected to h:1"));
    QCOMPARE(log[1], QString("2 airrobot/cpp: started"));
    QCOMPARE(log[2], QString("3 behavior: low battery – \"soon\""));
    QCOMPARE(log[3], QString("3 simulator: wind of 3 m/s"));
    QVERIFY2(log[4].contains("protocol: "), qPrintable(log[4]));
    QCOMPARE(log[5], QString("4 behavior: Landed on request."));
    QCOMPARE(log[6], QString("3 session: the connection was lost: the server is gone"));
    QVERIFY2(log[7].startsWith("3 recording: ") && log[7].contains("not ended in order"), qPrintable(log[7]));
}

void tst_RecordingMcap::aServerThatBeginsAgainGoesOnInTime() {
    Tape tape;
    tape.in("STA {Time 100.0} {Battery 1000}");
    tape.add({.kind = RecordKind::Closed, .bytes = "gone"});
    tape.add({.kind = RecordKind::Opened, .bytes = "h:1"});
    tape.in("SEN {Time 0.5} {Type IR} {Name I Range 0.5}");
    tape.in("SEN {Time 1.5} {Type IR} {Name I Range 0.5}");
    const auto found = exported(tape.bytes).of("/R_1/range/I");
    QCOMPARE(found.size(), std::size_t(2));
    QCOMPARE(found[0].published_ns, std::uint64_t(100'000'000'000));
    QCOMPARE(found[1].published_ns, std::uint64_t(101'000'000'000));
}

void tst_RecordingMcap::stripsBecomeADepthImage() {
    Tape tape;
    const std::string strip = "SEN {Time 1} {Type RangeImager} {Name k} {Resolution 2,2} {FOV 1.5,0.75} {Frames 2} ";
    tape.in(strip + "{Frame 1} {Range 9,9}"); // Of an image whose first strip was not recorded.
    tape.in(strip + "{Frame 0} {Range 1,2}");
    tape.in(strip + "{Frame 1} {Range 3,4}");
    const auto found = exported(tape.bytes).of("/R_1/image/k");
    QCOMPARE(found.size(), std::size_t(1));
    const QJsonObject json = found.front().json();
    QCOMPARE(json["width"].toInt(), 2);
    QCOMPARE(json["height"].toInt(), 2);
    QCOMPARE(json["step"].toInt(), 8);
    QCOMPARE(json["encoding"].toString(), QString("32FC1"));
    const float depths_m[] = {1, 2, 3, 4};
    QCOMPARE(QByteArray::fromBase64(json["data"].toString().toLatin1()),
             QByteArray(reinterpret_cast<const char*>(depths_m), sizeof depths_m));
}

/// The trace of 1000 cycles has several key frames, of which each begins anew.
void tst_RecordingMcap::aPlansActivePartsAreTold() {
    const std::string plan = "((DC rover (drives ((danger (trigger ((near))) back)) ((way go)))))";
    Tape tape;
    tape.publish(agent::PlanTrace{"pieces behind a lost beginning say nothing"});
    for (const std::string& piece : test::piecesOf(plan, 1000, 600))
        tape.publish(agent::PlanTrace{piece});
    const auto found = exported(tape.bytes).of("/R_1/plan");
    QCOMPARE(found.size(), std::size_t(2));
    QCOMPARE(found[0].json()["plan"].toString(), QString("rover"));
    QCOMPARE(found[0].json()["cycle"].toInt(), 1);
    QCOMPARE(found[0].json()["active"].toArray(), QJsonArray{"rover ▸ danger ▸ back"});
    QCOMPARE(found[1].json()["cycle"].toInt(), 601);
    QCOMPARE(found[1].json()["active"].toArray(), QJsonArray{"rover ▸ way ▸ go"});
}

void tst_RecordingMcap::theMapIsThatOfTheRecording() {
    const auto maps = exported(flight(40).bytes).of("/R_1/map");
    QCOMPARE(maps.size(), std::size_t(2)); // The first, and the last.
    const auto map = readRecordedMap(path("a.usarrec"));
    QVERIFY(map && map->missing.empty() && !map->record.raster.empty());
    const mapping::Raster& raster = map->record.raster;
    const QJsonObject json = maps.back().json();
    const std::int64_t columns = json["column_count"].toInt();
    QCOMPARE(columns, raster.columns);
    QCOMPARE(json["cell_size"].toObject()["x"].toDouble(), 0.5);
    const QJsonObject corner = json["pose"].toObject()["position"].toObject();
    QCOMPARE(corner["x"].toDouble(), raster.upper_left_center_m.x() - 0.25);
    QCOMPARE(corner["y"].toDouble(), raster.upper_left_center_m.y() - double(raster.rows) * 0.5 + 0.25);
    const QByteArray data = QByteArray::fromBase64(json["data"].toString().toLatin1());
    QCOMPARE(data.size(), qsizetype(raster.heights_m.size() * sizeof(float)));
    int known = 0;
    for (std::int64_t row = 0; row < raster.rows; ++row)
        for (std::int64_t column = 0; column < columns; ++column) {
            float height_m = 0.0f;
            std::memcpy(&height_m, data.constData() + (row * columns + column) * 4, sizeof height_m);
            const float wanted_m =
                raster.heights_m[static_cast<std::size_t>((raster.rows - 1 - row) * columns + column)];
            QVERIFY(height_m == wanted_m || (std::isnan(height_m) && std::isnan(wanted_m)));
            known += std::isnan(height_m) ? 0 : 1;
        }
    QVERIFY2(known > 100, qPrintable(QString::number(known)));
}

void tst_RecordingMcap::mapsAreAtMostHalfOfTheFile() {
    const auto file = exported(flight(2000).bytes);
    const auto maps = file.of("/R_1/map");
    QVERIFY2(maps.size() > 5 && maps.size() < 41, qPrintable(QString::number(maps.size())));
    std::size_t bytes_of_maps = 0, bytes = 0;
    for (const auto& map : maps)
        bytes_of_maps += map.data.size();
    for (const auto& message : file.messages)
        bytes += message.data.size();
    QVERIFY(bytes_of_maps - maps.back().data.size() <= bytes / 2);
    for (std::size_t map = 1; map + 1 < maps.size(); ++map)
        QVERIFY(maps[map].logged_ns - maps[map - 1].logged_ns >= 10'000'000'000);
}

void tst_RecordingMcap::aTornRecordingIsExportedAsFarAsItGoes() {
    const Tape tape = flight(10);
    std::size_t most = 0;
    for (std::size_t size = 100; size < tape.bytes.size(); size += 997) {
        std::string complaint;
        const auto file = exported(tape.bytes.substr(0, size), &complaint);
        QVERIFY(file.messages.size() >= most); // The longer, the more.
        most = std::max(most, file.messages.size());
        QVERIFY2(complaint.find("not ended in order") != std::string::npos, complaint.c_str());
    }
    QVERIFY(most > 30);
}

void tst_RecordingMcap::aGarbledRecordingIsExportedAroundTheDamage() {
    Tape tape = flight(100);
    const std::size_t whole = exported(tape.bytes).messages.size();
    for (std::size_t at = 2000; at < tape.bytes.size(); at += 5000)
        tape.bytes[at] = static_cast<char>(tape.bytes[at] ^ 0x20);
    std::string complaint;
    const std::size_t left = exported(tape.bytes, &complaint).messages.size();
    QVERIFY2(left > whole / 2 && left < whole, qPrintable(QString("%1 of %2").arg(left).arg(whole)));
    QVERIFY2(complaint.find("damaged") != std::string::npos, complaint.c_str());
}

void tst_RecordingMcap::manyTopicsAreCutOff() {
    Tape tape;
    for (int sensor = 0; sensor < 2000; ++sensor)
        tape.in("SEN {Time 1} {Type IR} {Name I" + std::to_string(sensor) + " Range 0.5}");
    std::string complaint;
    const auto file = exported(tape.bytes, &complaint);
    QVERIFY(!file.of("/R_1/range/I100").empty() && file.of("/R_1/range/I1000").empty());
    QVERIFY2(complaint.find("too many topics") != std::string::npos, complaint.c_str());
}

void tst_RecordingMcap::refusalsNameTheFileAndTheMend_data() {
    QTest::addColumn<QString>("recording");
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("words");
    const QString good = path("good.usarrec");
    doubles::writeAll(good.toStdString(), flight(3).bytes);
    doubles::writeAll(path("text.usarrec").toStdString(), "nothing");
    QTest::newRow("no recording") << path("none.usarrec") << path("x.mcap") << path("none.usarrec") + ": ";
    QTest::newRow("another file") << path("text.usarrec") << path("x.mcap") << path("text.usarrec") + ": ";
    QTest::newRow("no folder") << good << path("none/x.mcap") << path("none/x.mcap") + ": cannot write";
    QTest::newRow("a folder") << good << folder_.path() << "it is left alone. Give the output another name";
    QTest::newRow("a file below a file") << good << good + "/x.mcap" << good + "/x.mcap: cannot write";
    QTest::newRow("a full disk") << good << "/dev/full"
                                 << "/dev/full: there is a file of this name already";
}

void tst_RecordingMcap::refusalsNameTheFileAndTheMend() {
    QFETCH(QString, recording);
    QFETCH(QString, file);
    QFETCH(QString, words);
    const auto summary = recordingToMcapFile(recording, file, false);
    QVERIFY(!summary);
    const QString text = QString::fromStdString(summary.error().text());
    QVERIFY2(text.contains(words) && text.count('.') >= 2, qPrintable(text));
    QVERIFY(QDir(folder_.path()).entryList({"x.mcap*"}, QDir::Files).isEmpty());
}

void tst_RecordingMcap::aCancelledExportLeavesNothing() {
    doubles::writeAll(path("long.usarrec").toStdString(), flight(3000).bytes);
    std::stop_source stop;
    int told = 0;
    const auto summary = recordingToMcapFile(path("long.usarrec"), path("y.mcap"), false, stop.get_token(),
                                             [&](Seconds done, Seconds whole) {
                                                 QVERIFY(done >= Seconds{0.0} && done <= whole);
                                                 ++told;
                                                 stop.request_stop();
                                             });
    QCOMPARE(told, 1);
    QVERIFY(!summary);
    QVERIFY2(summary.error().text().find("cancelled") != std::string::npos, summary.error().text().c_str());
    QVERIFY(QDir(folder_.path()).entryList({"y.mcap*"}, QDir::Files | QDir::Hidden).isEmpty());
}

void tst_RecordingMcap::anExistingFileIsReplacedOnlyOnRequest() {
    doubles::writeAll(path("b.usarrec").toStdString(), flight(3).bytes);
    doubles::writeAll(path("b.mcap").toStdString(), "mine");
    QVERIFY(!recordingToMcapFile(path("b.usarrec"), path("b.mcap"), false));
    QVERIFY(doubles::readAll(path("b.mcap").toStdString()) == "mine");
    QVERIFY(recordingToMcapFile(path("b.usarrec"), path("b.mcap"), true));
    QVERIFY(doubles::readAll(path("b.mcap").toStdString()).size() > 1000);
}

void tst_RecordingMcap::nothingIsBegunAfterACancel() {
    std::stop_source stop;
    stop.request_stop();
    const auto summary = recordingToMcapFile(path("none.usarrec"), path("y.mcap"), false, stop.get_token());
    QVERIFY(!summary);
    QVERIFY2(summary.error().text().find("cancelled") != std::string::npos, summary.error().text().c_str());
}

void tst_RecordingMcap::theRecordingItselfIsLeftAlone() {
    const std::string bytes = flight(3).bytes;
    doubles::writeAll(path("c.usarrec").toStdString(), bytes);
    QVERIFY(QFile::link(path("c.usarrec"), path("link.usarrec")));
    for (const char* name : {"c.usarrec", "link.usarrec"}) {
        const auto summary = recordingToMcapFile(path("c.usarrec"), path(name), true);
        QVERIFY(!summary);
        QVERIFY2(summary.error().text().find("recording itself") != std::string::npos, summary.error().text().c_str());
        QVERIFY(doubles::readAll(path("c.usarrec").toStdString()) == bytes);
    }
}

USAR_TEST(tst_RecordingMcap)

} // namespace tst_recording_mcap

#include "tst_recording_mcap.moc"
