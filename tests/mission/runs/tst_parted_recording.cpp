// What is made of recordings is the same, whether they are in parts or not. The parts are cut as in a flight.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <limits>
#include <set>
#include <string>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/random.h"
#include "core/link/replay.h"
#include "core/mission/files/flown_mission.h"
#include "core/mission/reports/recorded_runs.h"
#include "core/mission/runs/export_source.h"
#include "core/mission/runs/flight_moment.h"
#include "core/mission/runs/recorded_scan.h"
#include "core/mission/runs/recording_mcap.h"
#include "core/mission/session/record_keeping.h"
#include "tests/doubles/mcap_file.h"
#include "tests/doubles/plan_trace.h"
#include "tests/doubles/test_files.h"
#include "tests/mission/session/session_parts.h"
#include "tests/suite/suite.h"

namespace tst_parted_recording {

using namespace usar;
using namespace usar::mission;

namespace {

constexpr int scans = 60;
const Rectangle area_in_map{{-5.0, -5.0}, {50.0, 5.0}};

/// A session that is recorded, with a limit or without one.
class Recorded : public test::NoticeBook {
public:
    Recorded(const QString& path, RecordingLimit limit_bytes) {
        scene_.link.host = "h";
        scene_.link.port = 1;
        scene_.cell_size_m = 0.5;
        records_.setLimit(limit_bytes);
        begun_ = records_.begin(path, {{"robot", "R1"}}).has_value();
        scene_.link.state = link::LinkState::Connected;
        records_.opened("h:1");
        scene_.robot = protocol::Init{"USARBot.AirRobot", "R1"};
        records_.sent({by::Session{"spawn"}, {}}, "INIT {ClassName USARBot.AirRobot} {Name R1} {Location 0,0,-5}");
    }
    bool begun() const { return begun_; }
    void line(const std::string& text) {
        records_.received(text + "\r\n");
        incoming_.take(text);
    }
    void start(const FlownMission& flown) {
        task_.behavior_id = "airrobot/cpp";
        task_.robot_name = "R1";
        task_.area_in_map = area_in_map;
        scene_.of_behavior = &task_;
        records_.noteMission(noteOf(flown));
        records_.noteTask(task_);
    }
    void publish(const agent::Published& value) { records_.notePublished(value, true); }
    void fault(const std::string& sentence) { records_.noteFault(sentence); }
    LineNumber newest() const { return incoming_.newest(); }
    void look() {
        for (int i = 0; i < 2; ++i) {
            std::promise<void> flushed;
            records_.flush([&flushed] { flushed.set_value(); });
            flushed.get_future().wait();
            if (i == 0)
                records_.look();
        }
    }
    void end() { records_.end(); }

private:
    QObject owner_;
    Incoming incoming_;
    RecordingScene scene_;
    ScanRecord task_;
    bool begun_ = false;
    RecordKeeping records_{owner_, notices, incoming_, [this] { return scene_; }, [] {}};
};

/// Letters that cannot be compressed by much, in a line that nobody understands.
std::string noiseLine(Random& random) {
    std::string line = "NOISE {";
    for (int i = 0; i < 3750; ++i)
        for (auto [eight, left] = std::pair(random(), 8); left > 0; --left, eight >>= 8)
            line += static_cast<char>('!' + (eight & 0xff) % 90);
    return line + '}';
}

/// Flies along 30 m over level ground, with a plan, and with a fault from near the beginning on.
void fly(Recorded& session) {
    Random random(5);
    const auto pieces =
        test::piecesOf("((DC rover (drives ((danger (trigger ((near))) back)) ((way go)))))", scans, scans / 2);
    session.line("GEO {Type RangeScanner} {Name S1 Location 0,0,0 Orientation 0,-1.5707963,0 Mount HARD}");
    session.line("CONF {Type RangeScanner} {Name S1} {MaxRange 20.0} {MinRange 0.1} {Resolution 0.02} {Fov 1.2}");
    FlownMission flown;
    flown.mission.name = "Cut";
    flown.mission.behavior = "airrobot/cpp";
    flown.mission.area_in_map = area_in_map;
    flown.mission.cell_size_m = 0.5;
    flown.seed = 7;
    session.start(flown);
    for (int scan = 0; scan < scans; ++scan) {
        const double now_s = 20.0 + 0.2 * scan;
        const std::string time = std::to_string(now_s);
        std::string ranges;
        for (int beam = -30; beam <= 30; ++beam)
            ranges += (ranges.empty() ? "" : ",") + std::to_string(5.0 / std::cos(0.02 * beam));
        session.line("STA {Type AerialVehicle} {Time " + time + "} {Battery 1000}");
        session.line("SEN {Time " + time + "} {Type RangeScanner} {Name S1} {Resolution 0.02} {FOV 1.2} {Range " +
                     ranges + "}");
        const Pose base_in_map{.position_m = {0.5 * scan, 0.0, 5.0}};
        session.publish(agent::PoseEstimate{Seconds{now_s}, base_in_map});
        session.publish(agent::ScanPlacement{session.newest(), base_in_map * Pose{.pitch_rad = pi / 2.0}});
        agent::BehaviorStatus status;
        status.time = Seconds{now_s};
        status.elapsed = Seconds{0.2 * scan};
        status.state = "leg " + std::to_string(scan / 10);
        session.publish(status);
        session.publish(agent::PlanTrace{pieces[static_cast<std::size_t>(scan)]});
        if (scan == 2)
            session.fault("20.4 s: fault begins: wind speed=5");
        session.line(noiseLine(random));
        session.line(noiseLine(random));
        if (scan % 5 == 4)
            session.look();
    }
    session.publish(agent::BehaviorFinished{true, "Done."});
}

/// Remembers the newest time that the robot's clock told.
struct ClockListener : link::ReplayTaker {
    std::string newest;
    int lines = 0;
    void rewound() override { lines = 0; }
    void opened(std::string_view) override {}
    void closed(std::string_view) override {}
    void line(std::string_view text, LineNumber) override {
        ++lines;
        if (text.starts_with("STA"))
            newest = text;
    }
    void sent(const link::Record&) override {}
    void note(const link::Record&) override {}
    void quiet(bool) override {}
};

} // namespace

class tst_PartedRecording : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        for (const char* name : {"whole/a.usarrec", "cut/a.usarrec"}) {
            const bool cut = QString(name).startsWith("cut");
            QVERIFY(QDir(folder_.path()).mkpath(QFileInfo(path(name)).path()));
            Recorded session(path(name), cut ? RecordingLimit(10'000'000) : std::nullopt);
            QVERIFY(session.begun());
            fly(session);
            session.end();
            QCOMPARE(session.said.size(), std::size_t(0));
        }
        QCOMPARE(partsIn("whole"), 1);
        QVERIFY(partsIn("cut") >= 3);
        // The beginning of this one is gone.
        QVERIFY(QDir(folder_.path()).mkpath("late"));
        for (const QString& name : QDir(path("cut")).entryList(QDir::Files))
            if (name != "a.part1.usarrec")
                QVERIFY(QFile::copy(path("cut/") + name, path("late/") + name));
        // Nothing is left in the two newest files of this one, as after a loss of power.
        QVERIFY(QDir(folder_.path()).mkpath("early"));
        for (const QString& name : QDir(path("cut")).entryList(QDir::Files))
            QVERIFY(QFile::copy(path("cut/") + name, path("early/") + name));
        QVERIFY(QFile::resize(path("early/a.usarrec"), 0));
        QVERIFY(QFile::resize(path(QString("early/a.part%1.usarrec").arg(partsIn("cut") - 1)), 0));
    }

    void theyHoldTheSameLines() {
        const auto linesOf = [](const QString& file) {
            ClockListener listener;
            link::Replayer replayer(*link::RecordingReader::open(file), listener);
            QSignalSpy ended(&replayer, &link::Replayer::ended);
            replayer.setSpeed(std::numeric_limits<double>::infinity());
            replayer.setPlaying(true);
            return ended.wait(30'000) ? listener.lines : -1;
        };
        QCOMPARE(linesOf(path("whole/a.usarrec")), 2 + 4 * scans);
        QCOMPARE(linesOf(path("cut/a.usarrec")), 2 + 4 * scans);
    }

    void aMomentIsFoundByTheRobotsClock_data() {
        QTest::addColumn<double>("clock_s");
        QTest::addColumn<QString>("newest");
        for (const double clock_s : {20.0, 23.1, 25.9, 28.3, 31.75})
            QTest::addRow("%g s", clock_s)
                << clock_s << QString::number(std::floor(clock_s * 5.0 + 1e-9) / 5.0, 'f', 6);
    }
    void aMomentIsFoundByTheRobotsClock() {
        QFETCH(const double, clock_s);
        QFETCH(const QString, newest);
        for (const char* name : {"whole/a.usarrec", "cut/a.usarrec"}) {
            ClockListener listener;
            link::Replayer replayer(*link::RecordingReader::open(path(name)), listener);
            replayer.seekToClock(Seconds{clock_s});
            QTRY_VERIFY(!replayer.figures().seeking);
            QVERIFY2(listener.newest.find("{Time " + newest.toStdString()) != std::string::npos,
                     listener.newest.c_str());
        }
    }

    void theTraceOfThePlanIsTheSame() {
        const auto whole = readTraces(path("whole/a.usarrec"));
        const auto cut = readTraces(path("cut/a.usarrec"));
        const auto late = readTraces(path("late/a.usarrec"));
        QVERIFY(whole && cut && late);
        QCOMPARE(whole->traces.size(), std::size_t(1));
        QVERIFY(cut->traces == whole->traces);
        QCOMPARE(cut->complaint, std::string());
        QVERIFY(late->traces == whole->traces); // It is told once more at the beginning of each part.
        QVERIFY(late->complaint.starts_with("The first part of this recording is missing"));
    }

    void aMomentIsToldTheSame() {
        const std::atomic_bool going_on(false);
        const auto whole = readFlightMoment(path("whole/a.usarrec"), Seconds{29.0}, going_on);
        const auto cut = readFlightMoment(path("cut/a.usarrec"), Seconds{29.0}, going_on);
        const auto late = readFlightMoment(path("late/a.usarrec"), Seconds{29.0}, going_on);
        QVERIFY(whole && cut && late);
        std::set<std::string> states;
        for (const auto& [time, state] : whole->states)
            states.insert(state);
        QVERIFY(states.size() == 6 && !whole->element_runs.empty());
        QCOMPARE(whole->flown.mission.faults, std::vector<std::string>{"wind speed=5 from=0.40"});
        for (const auto* other : {&*cut, &*late}) {
            QCOMPARE(other->at, whole->at);
            QCOMPARE(other->last, whole->last);
            QCOMPARE(other->flown.mission.faults, whole->flown.mission.faults);
        }
        QVERIFY(cut->states == whole->states);
        QVERIFY(cut->element_runs == whole->element_runs);
        QVERIFY(cut->heights_m == whole->heights_m);
    }

    void theMapIsTheSame() {
        const auto whole = readRecordedScan(path("whole/a.usarrec"), true);
        const auto cut = readRecordedScan(path("cut/a.usarrec"), true);
        QVERIFY(whole && cut);
        QVERIFY(whole->finished && cut->finished && whole->scan.record.scans && cut->scan.record.scans);
        QCOMPARE(cut->missing, std::string());
        QVERIFY(whole->scan.run.cells > 500);
        QCOMPARE(cut->scan.run.cells, whole->scan.run.cells);
        QCOMPARE(cut->scan.record.scans->size(), whole->scan.record.scans->size());
        QCOMPARE(cut->rest_in_map, whole->rest_in_map);
        QCOMPARE(cut->start_in_map.has_value(), whole->start_in_map.has_value());
    }

    void aMapWhoseBeginningOrEndIsMissingSaysSo_data() {
        QTest::addColumn<QString>("recording");
        QTest::addColumn<QString>("words");
        QTest::newRow("beginning") << "late/a.usarrec"
                                   << "a.usarrec: The first part of this recording is missing, because "
                                      "a.part1.usarrec is gone or elsewhere; it begins ";
        QTest::newRow("end") << "early/a.usarrec"
                             << "a.usarrec: The end of this recording is missing, because nothing can be read in "
                                "a.usarrec (the file is empty), ";
    }
    void aMapWhoseBeginningOrEndIsMissingSaysSo() {
        QFETCH(const QString, recording);
        QFETCH(const QString, words);
        const auto whole = readRecordedScan(path("whole/a.usarrec"));
        const auto less = readRecordedScan(path(recording));
        QVERIFY(whole && less);
        QVERIFY2(less->missing.starts_with(words.toStdString()), less->missing.c_str());
        QCOMPARE(less->flown.mission.area_in_map, area_in_map);
        QVERIFY(less->scan.run.cells > 0 && less->scan.run.cells < whole->scan.run.cells);
        QVERIFY(less->rest_in_map.area_m2() >= whole->rest_in_map.area_m2());
        const auto source = openExportSource(path(recording), false);
        QVERIFY(source);
        QCOMPARE(source->missing, less->missing);
        QVERIFY(openExportSource(path("cut/a.usarrec"), false)->missing.empty());
    }

    void theExportForOtherProgramsIsTheSame() {
        const doubles::McapFile whole = exported("whole"), cut = exported("cut");
        QVERIFY2(whole.messages.size() > 3 * scans, qPrintable(QString::number(whole.messages.size())));
        QCOMPARE(cut.messages.size(), whole.messages.size());
        for (std::size_t i = 0; i < whole.messages.size(); ++i)
            QVERIFY2(cut.messages[i] == whole.messages[i],
                     qPrintable(QString("message %1: %2 and %3")
                                    .arg(i)
                                    .arg(QString::fromStdString(whole.messages[i].data).left(300),
                                         QString::fromStdString(cut.messages[i].data).left(300))));
    }

    void aMissingBeginningIsNoDamage() {
        const auto late = recordingToMcapFile(path("late/a.usarrec"), path("late.mcap"), true);
        QVERIFY(late);
        QVERIFY(late->complaint.starts_with("The first part of this recording is missing"));
        QVERIFY(!late->damaged);
        QVERIFY(QDir(folder_.path()).mkpath("torn"));
        QVERIFY(QFile::copy(path("whole/a.usarrec"), path("torn/a.usarrec")));
        QVERIFY(QFile::resize(path("torn/a.usarrec"), QFileInfo(path("torn/a.usarrec")).size() / 2));
        const auto torn = recordingToMcapFile(path("torn/a.usarrec"), path("torn.mcap"), true);
        QVERIFY(torn && torn->damaged);
    }

private:
    QString path(const QString& name) const { return folder_.filePath(name); }
    int partsIn(const QString& folder) const {
        return static_cast<int>(QDir(path(folder)).entryList(QDir::Files).size());
    }
    doubles::McapFile exported(const QString& name) {
        const auto summary = recordingToMcapFile(path(name + "/a.usarrec"), path(name + ".mcap"), true);
        std::string trouble = summary ? "" : summary.error().text();
        auto file =
            doubles::readMcap(doubles::readAll(doubles::pathOf(folder_) / (name + ".mcap").toStdString()), trouble);
        if (!summary || !file)
            QTest::qFail(trouble.c_str(), __FILE__, __LINE__);
        return file.value_or(doubles::McapFile{});
    }

    QTemporaryDir folder_;
};

USAR_TEST(tst_PartedRecording)

} // namespace tst_parted_recording

#include "tst_parted_recording.moc"
