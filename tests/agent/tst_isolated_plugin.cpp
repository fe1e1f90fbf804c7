// Plugins that a process of its own is asked about: nobody waits for it, whatever it does.
#include <algorithm>
#include <optional>
#include <vector>

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QStringLiteral>
#include <QTemporaryDir>
#include <QTest>

#include "core/agent/plugins/plugin_loader.h"
#include "core/agent/process/behavior_frames.h"
#include "tests/suite/suite.h"

namespace tst_isolated_plugin {

using namespace usar;
using namespace usar::agent;

namespace {

const QString plugins = QStringLiteral(USAR_BINARY_DIR "/tests/plugins/");
const QString airrobot = QStringLiteral(USAR_BINARY_DIR "/robots/airrobot.so");
const QString crashing = plugins + "dangerous/crashes_in_the_program.so";
const QString slow = plugins + "dangerous/slow_to_tell.so";
const QString host = QStringLiteral(USAR_BINARY_DIR "/bin/usar-behavior-host");
constexpr int answered_ms = 15000;

/// A loader that isolates these, with what it has told since.
struct Asking {
    explicit Asking(const QStringList& files, const QStringList& isolated, const Patience& patience = {}) {
        loader.setPolicy({.host_program = host, .isolated = isolated, .patience = patience});
        loader.setNews([this](const std::vector<PluginChange>& changes) {
            for (const PluginChange& change : changes)
                news.push_back(change.news);
        });
        loader.scan(files);
    }
    PluginState state(std::size_t i = 0) const { return loader.records()[i].state; }
    bool answered() const {
        return QTest::qWaitFor(
            [&] {
                return std::ranges::none_of(loader.records(),
                                            [](const auto& r) { return r.state == PluginState::Asked; });
            },
            answered_ms);
    }
    BehaviorContext contextOf(const std::string& id, const Rectangle& area) const {
        return {{"R1", {}, area}, *ParameterSet::make(loader.behavior(id)->parameters)};
    }
    Result<TaskPreview> preview(const std::string& id, const Rectangle& area) const {
        std::optional<Result<TaskPreview>> got;
        loader.preview(id, contextOf(id, area), [&](const Result<TaskPreview>& told) { got = told; });
        if (!QTest::qWaitFor([&] { return got.has_value(); }, answered_ms))
            return failure("nothing was told", id);
        return *got;
    }

    PluginLoader loader;
    std::vector<PluginNews> news;
};

Rectangle area(double width_m) {
    return {{0.0, 0.0}, {width_m, 3.0}};
}

} // namespace

class tst_IsolatedPlugin : public QObject {
    Q_OBJECT
private slots:
    void cleanup() { qunsetenv("USAR_TEST_SLOW_S"); }

    void itSaysTheSameOfItselfAsInTheProgram_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("name");
        QTest::addColumn<std::string>("id");
        QTest::newRow("a good one") << plugins + "good.so"
                                    << "Test robot" << std::string("test/idle");
        QTest::newRow("with parameters, senses and acts, and previews")
            << airrobot << "AirRobot" << std::string("airrobot/posh");
    }

    void itSaysTheSameOfItselfAsInTheProgram() {
        QFETCH(QString, file);
        QFETCH(QString, name);
        QFETCH(std::string, id);
        PluginLoader here;
        here.scan({file});
        QCOMPARE(here.records().front().metadata.value("name").toString(), name);
        const Asking there({file}, {name});
        QVERIFY(there.answered());
        const PluginRecord& record = there.loader.records().front();
        QVERIFY2(record.state == PluginState::Loaded, qPrintable(record.reason));
        QVERIFY(record.isolated && !here.records().front().isolated);
        const auto asBytes = [](const RobotDescription& robot) { return frames::write(frames::Reply(robot)); };
        QCOMPARE(asBytes(there.loader.robots().front()), asBytes(here.robots().front()));

        const BehaviorContext context = there.contextOf(id, {{0.0, 0.0}, {40.0, 30.0}});
        const auto expected = (*here.pluginFor(id))->preview(id, context);
        const auto got = there.preview(id, context.task.area_in_map);
        QVERIFY(expected && got);
        QVERIFY(got->path_in_map_m == expected->path_in_map_m && got->summary == expected->summary);
        QCOMPARE(got->length_m, expected->length_m);
        QCOMPARE(got->duration.count(), expected->duration.count());
        const RobotPlugin& stand_in = **there.loader.pluginFor(id);
        const auto made = stand_in.createBehavior(id, context);
        QVERIFY(!made && made.error().text().find("is not loaded into this program") != std::string::npos);
        QVERIFY(!stand_in.preview(id, context)); // it would have to wait
    }

    void itIsNeverOpenedInTheProgram() {
        const Asking there({crashing}, {"Crashing robot"}); // this program would not live to see it
        QVERIFY(there.answered());
        QVERIFY2(there.state() == PluginState::Loaded, qPrintable(there.loader.records().front().reason));
        QCOMPARE(there.preview("test/idle", area(4.0))->summary, std::string("one lane"));
        const auto crashed = there.preview("test/idle", {});
        QVERIFY(!crashed);
        QVERIFY2(crashed.error().text().find("died by SIGABRT") != std::string::npos, crashed.error().text().c_str());
        QCOMPARE(there.preview("test/idle", area(4.0))->summary, std::string("one lane")); // by a new process
    }

    void whileItIsAskedItsMetadataSayWhatThereIs() {
        qputenv("USAR_TEST_SLOW_S", "0.3");
        const Asking there({slow, airrobot}, {"Slow robot"});
        QCOMPARE(there.state(), PluginState::Asked);
        QVERIFY(there.loader.isAsked("slow/idle") && !there.loader.isAsked("airrobot/cpp"));
        QVERIFY(there.loader.recordOf("slow/idle") == &there.loader.records().front());
        const auto kinds = there.loader.kinds();
        QCOMPARE(kinds.size(), std::size_t(1));
        QCOMPARE(kinds.front().name, std::string("AirRobot"));
        QCOMPARE(kinds.front().behaviors.size(), std::size_t(3));
        QCOMPARE(kinds.front().behaviors.front().id, std::string("slow/idle")); // files keep their order
        QCOMPARE(kinds.front().behaviors.front().name, std::string("slow/idle (asking…)"));
        QVERIFY(!there.loader.behavior("slow/idle"));
        QVERIFY(there.loader.pluginFor("slow/idle").error().text().find("still being asked") != std::string::npos);
        QVERIFY(there.loader.behavior("airrobot/cpp")); // nobody else waits

        QVERIFY(there.answered());
        QCOMPARE(there.loader.kinds().front().behaviors.front().name, std::string("Idle at last"));
        QVERIFY(!there.loader.isAsked("slow/idle") && there.loader.behavior("slow/idle"));
    }

    void itsNewsComeWhenItHasAnswered() {
        const QTemporaryDir folder;
        const QString file = folder.filePath("0.so");
        const QString another = folder.filePath("1.so");
        QVERIFY(QFile::copy(plugins + "good.so", file));
        Asking there({folder.path()}, {"Test robot"});
        QVERIFY(there.answered());
        QCOMPARE(there.news, std::vector{PluginNews::Described}); // it was there from the first
        QVERIFY(there.loader.rescan().empty());

        there.news.clear();
        there.loader.forget(file);
        QCOMPARE(there.loader.rescan().front().news, PluginNews::Asked);
        QVERIFY(there.loader.rescan().empty()); // said once
        QVERIFY(there.answered());
        QCOMPARE(there.news, std::vector{PluginNews::Rebuilt});

        there.news.clear();
        QVERIFY(QFile::copy(crashing, another));
        there.loader.setPolicy({.host_program = host, .isolated = {"Test robot", "Crashing robot"}});
        QCOMPARE(there.loader.rescan().front().news, PluginNews::Asked);
        QVERIFY(there.answered());
        QCOMPARE(there.news, std::vector{PluginNews::Refused}); // both have test/idle
        QVERIFY(QFile::remove(file));
        QCOMPARE(there.loader.rescan().back().news, PluginNews::Removed);
        QVERIFY2(there.loader.recordOf("test/idle")->file == another,
                 qPrintable(there.loader.recordOf("test/idle")->file));
    }

    void anIdThatIsPromisedIsNotGivenToAnother() {
        const Asking there({crashing, plugins + "good.so"}, {"Crashing robot"});
        QCOMPARE(there.state(0), PluginState::Asked);
        QCOMPARE(there.state(1), PluginState::Rejected);
        QVERIFY(there.loader.records()[1].reason.contains("test/idle is there already"));
        QVERIFY(there.answered());
        QCOMPARE(there.loader.recordOf("test/idle")->file, crashing);
    }

    void oneThatHangsIsRefusedAfterItsTimeAndCanBeAskedAgain() {
        qputenv("USAR_TEST_SLOW_S", "60");
        QElapsedTimer clock;
        clock.start();
        Asking there({slow}, {"Slow robot"}, {.loading = Seconds{0.3}});
        QCOMPARE(there.state(), PluginState::Asked); // nobody has waited for it
        QVERIFY(there.answered());
        QVERIFY2(clock.elapsed() >= 300, qPrintable(QString::number(clock.elapsed())));
        const PluginRecord& record = there.loader.records().front();
        QVERIFY2(record.reason.contains("did not answer for 0.3 s while being loaded"), qPrintable(record.reason));
        QCOMPARE(there.news, std::vector{PluginNews::Refused});
        QVERIFY(there.loader.kinds().empty());

        qunsetenv("USAR_TEST_SLOW_S");
        there.loader.setPolicy({.host_program = host, .isolated = {"Slow robot"}});
        there.loader.forget(slow);
        QCOMPARE(there.loader.rescan().front().news, PluginNews::Asked);
        QVERIFY(there.answered());
        QCOMPARE(there.state(), PluginState::Loaded);
        QCOMPARE(there.news.back(), PluginNews::Added);
    }

    void oneThatIsKilledLeavesNoFilesBehind() {
        const QByteArray before = qgetenv("TMPDIR");
        const QTemporaryDir temporary;
        qputenv("TMPDIR", QFile::encodeName(temporary.path()));
        qputenv("USAR_TEST_SLOW_S", "60");
        const auto left = [&] { return QDir(temporary.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot); };
        {
            const Asking there({slow}, {"Slow robot"}, {.loading = Seconds{0.3}});
            QVERIFY(!left().empty()); // or the rest would say nothing
            QVERIFY(there.answered());
            QCOMPARE(there.state(), PluginState::Rejected);
        }
        before.isNull() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", before);
        QCOMPARE(left(), QStringList());
    }

    void whatCannotBeAskedAtAllIsRefusedAtOnce() {
        PluginLoader loader;
        loader.setPolicy({.host_program = "/nowhere/usar-behavior-host", .isolated = {"Test robot"}});
        loader.scan({plugins + "good.so"});
        QCOMPARE(loader.records().front().state, PluginState::Rejected);
        QVERIFY(loader.records().front().reason.contains("cannot run in a separate process"));
    }

    void onlyTheNewestPreviewIsTold() {
        const Asking there({slow}, {"Slow robot"});
        QVERIFY(there.answered());
        std::vector<std::string> told;
        const auto ask = [&](double width_m) {
            there.loader.preview(
                "slow/idle", there.contextOf("slow/idle", area(width_m)),
                [&](const Result<TaskPreview>& got) { told.push_back(got ? got->summary : got.error().text()); });
        };
        for (const double width_m : {1.0, 2.0, 3.0, 4.0})
            ask(width_m);
        QVERIFY(told.empty()); // not yet
        QTRY_VERIFY_WITH_TIMEOUT(!told.empty(), answered_ms);
        QCOMPARE(told, std::vector<std::string>{"4 wide"});
        ask(5.0);
        there.loader.forgetPreview();
        ask(6.0);
        QTRY_COMPARE_WITH_TIMEOUT(told.size(), std::size_t(2), answered_ms);
        QCOMPARE(told.back(), std::string("6 wide"));
        ask(7.0);
        there.loader.forgetPreview();
        QCOMPARE(there.preview("slow/idle", area(8.0))->summary, std::string("8 wide")); // asked after it
        QCOMPARE(told.size(), std::size_t(2));
    }

    void aPreviewThatHangsIsToldOfAndTheNextOneHasANewProcess() {
        const Asking there({slow}, {"Slow robot"}, {.preview = Seconds{0.2}});
        QVERIFY(there.answered());
        const auto hung = there.preview("slow/idle", area(40.0));
        QVERIFY(!hung);
        QVERIFY2(hung.error().text().find("did not answer for 0.2 s while previewing a task") != std::string::npos,
                 hung.error().text().c_str());
        QCOMPARE(there.preview("slow/idle", area(5.0))->summary, std::string("5 wide"));
    }

    void whatIsWantedAfterAHangingPreviewIsStillTold() {
        const Asking there({slow}, {"Slow robot"}, {.preview = Seconds{0.2}});
        QVERIFY(there.answered());
        there.loader.preview("slow/idle", there.contextOf("slow/idle", area(40.0)),
                             [](const Result<TaskPreview>&) { QFAIL("an old one was told"); });
        QCOMPARE(there.preview("slow/idle", area(5.0))->summary, std::string("5 wide"));
    }
};

USAR_TEST(tst_IsolatedPlugin)

} // namespace tst_isolated_plugin

#include "tst_isolated_plugin.moc"
