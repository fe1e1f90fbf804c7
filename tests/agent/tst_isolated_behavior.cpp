#include <csignal>

#include <QObject>
#include <QSignalSpy>
#include <QSocketNotifier>
#include <QString>
#include <QStringLiteral>
#include <QTest>

#include "core/agent/behavior_host.h"
#include "core/agent/plugins/plugin_loader.h"
#include "core/agent/process/isolated_behavior.h"
#include "core/protocol/reader.h"
#include "tests/suite/signaling.h"
#include "tests/suite/suite.h"

namespace tst_isolated_behavior {

using namespace usar;
using namespace usar::agent;

namespace {

const QString program = QStringLiteral(USAR_BINARY_DIR "/bin/usar-behavior-host");
const QString plugin = QStringLiteral(USAR_BINARY_DIR "/tests/plugins/faulty.so");

std::unique_ptr<IsolatedBehavior> isolated(const std::string& id, double good_ticks = 3) {
    return std::make_unique<IsolatedBehavior>(
        program, frames::Start{plugin.toStdString(),
                               {id, {"R1", {}, {}}, {{"ticks", static_cast<long long>(good_ticks)}}, /*plan=*/{}}});
}

/// The lines of a robot, one a tick.
class Lines {
public:
    const protocol::InfoLine& next() {
        const std::string time = std::to_string(++ticks_) + ".5";
        return reader_.read("STA {Type AerialVehicle} {Time " + time + "} {Battery 1000}");
    }

private:
    protocol::Reader reader_;
    int ticks_ = 0;
};

QString reasonOf(const RunningBehavior::Output& output) {
    for (const Published& value : output.published)
        if (const auto* const finished = std::get_if<BehaviorFinished>(&value))
            return QString::fromStdString(finished->reason);
    return {};
}

/// What it says last, once the robot has been made safe.
RunningBehavior::Output withItsEnd(RunningBehavior& behavior, RunningBehavior::Output output) {
    if (behavior.ending())
        output.append(behavior.takeEnd());
    return output;
}

bool isSafe(const RunningBehavior::Output& output) {
    return !output.commands.empty() && std::ranges::all_of(output.commands, [](const CausedCommand& command) {
        return command.command == protocol::Command(protocol::AerialDrive{0.0, 0.0, 0.0, 0.0});
    });
}

} // namespace

class tst_IsolatedBehavior : public QObject {
    Q_OBJECT
private slots:
    void answersWhatItWouldAnswerInThisProcess();
    void ordersAndParametersReachIt();
    void aBehaviorThatEndsItsProcessIsStoppedAndTheWordsSayHow_data();
    void aBehaviorThatEndsItsProcessIsStoppedAndTheWordsSayHow();
    void aKilledOneIsSeenBetweenTwoLines_data();
    void aKilledOneIsSeenBetweenTwoLines();
    void aHangingOneIsKilled();
    void whatCannotBeStartedSaysWhy_data();
    void whatCannotBeStartedSaysWhy();
    void itsProcessEndsWithIt();
};

void tst_IsolatedBehavior::answersWhatItWouldAnswerInThisProcess() {
    PluginLoader plugins;
    plugins.scan({plugin});
    QVERIFY(plugins.behavior("faulty/none"));
    const auto parameters = ParameterSet::make(plugins.behavior("faulty/none")->parameters);
    BehaviorHost here(*(*plugins.pluginFor("faulty/none"))->createBehavior("faulty/none", {{}, *parameters}),
                      "faulty/none");
    const auto there = isolated("faulty/none");
    QCOMPARE(reasonOf(there->begin()), QString());
    QVERIFY(there->processId() > 0);
    Lines lines;
    for (int i = 0; i < 20; ++i) {
        const protocol::InfoLine line = lines.next();
        const auto expected = here.receive(line);
        const auto got = there->receive(line);
        QVERIFY(!expected.commands.empty() && !expected.published.empty());
        QVERIFY(got.commands == expected.commands);
        QVERIFY(got.published == expected.published);
    }
}

void tst_IsolatedBehavior::ordersAndParametersReachIt() {
    const auto behavior = isolated("faulty/throw", 100);
    behavior->begin();
    Lines lines;
    QVERIFY(!behavior->receive(lines.next()).commands.empty());
    const std::vector<ParameterSpec> specs{{"ticks", "Good ticks", "Fault", "", 0LL, 0.0, 1e6, "", {}}};
    behavior->setParameters(*ParameterSet::make(specs)); // from now on no tick goes well
    const auto thrown = behavior->receive(lines.next());
    QVERIFY2(reasonOf(thrown).contains("lost my way"), qPrintable(reasonOf(thrown)));
    QVERIFY(isSafe(thrown));

    const auto other = isolated("faulty/none");
    other->begin();
    QCOMPARE(reasonOf(other->order(Order::Pause)), QString("Ordered to end."));
    QVERIFY(other->finished());
}

void tst_IsolatedBehavior::aBehaviorThatEndsItsProcessIsStoppedAndTheWordsSayHow_data() {
    QTest::addColumn<QString>("fault");
    QTest::addColumn<QString>("words");
    QTest::newRow("segmentation fault") << "segfault"
                                        << "died by SIGSEGV (Segmentation fault)";
    QTest::newRow("abort") << "abort"
                           << "died by SIGABRT";
    QTest::newRow("exit") << "exit"
                          << "ended its process with exit code 3";
    QTest::newRow("killed, with a child that lives on") << "orphan"
                                                        << "died by SIGKILL";
    QTest::newRow("hangs up and lives on") << "hang up"
                                           << "broke the connection to its process";
}

void tst_IsolatedBehavior::aBehaviorThatEndsItsProcessIsStoppedAndTheWordsSayHow() {
    QFETCH(QString, fault);
    QFETCH(QString, words);
    const auto behavior = isolated("faulty/" + fault.toStdString());
    behavior->begin();
    Lines lines;
    for (int i = 0; i < 3; ++i)
        QVERIFY(!behavior->receive(lines.next()).commands.empty());
    const auto output = withItsEnd(*behavior, behavior->receive(lines.next()));
    const QString reason = reasonOf(output);
    QVERIFY2(reason.contains(words), qPrintable(reason));
    QVERIFY2(reason.contains("worked on line 4 (STA {Type AerialVehicle}"), qPrintable(reason));
    QVERIFY2(reason.contains("climbing for the 3. tick") && reason.contains("faulty/" + fault), qPrintable(reason));
    QVERIFY(isSafe(output));
    QVERIFY(behavior->finished());
    QVERIFY(behavior->receive(lines.next()).commands.empty());
    QVERIFY(behavior->endHandle() < 0);
}

void tst_IsolatedBehavior::aKilledOneIsSeenBetweenTwoLines_data() {
    QTest::addColumn<int>("signal");
    QTest::addColumn<QString>("name");
    QTest::newRow("SEGV") << SIGSEGV << "SIGSEGV";
    QTest::newRow("KILL") << SIGKILL << "SIGKILL";
}

void tst_IsolatedBehavior::aKilledOneIsSeenBetweenTwoLines() {
    QFETCH(int, signal);
    QFETCH(QString, name);
    const auto behavior = isolated("faulty/none");
    behavior->begin();
    Lines lines;
    behavior->receive(lines.next());
    QVERIFY(behavior->takeEnd().commands.empty()); // it is well
    QVERIFY(!behavior->finished());
    QSocketNotifier notifier(behavior->endHandle(), QSocketNotifier::Read);
    QSignalSpy seen(&notifier, &QSocketNotifier::activated);
    QVERIFY(test::sendSignal(behavior->processId(), signal));
    QVERIFY(seen.wait(5000));
    const auto output = withItsEnd(*behavior, behavior->takeEnd());
    QVERIFY2(reasonOf(output).contains("died by " + name), qPrintable(reasonOf(output)));
    QVERIFY2(reasonOf(output).contains("it waited after line 1 (STA"), qPrintable(reasonOf(output)));
    QVERIFY(isSafe(output));
}

void tst_IsolatedBehavior::aHangingOneIsKilled() {
    const auto behavior = isolated("faulty/loop", 1);
    behavior->setPatience(Seconds{0.5});
    behavior->begin();
    const int process = behavior->processId();
    Lines lines;
    behavior->receive(lines.next());
    const auto output = behavior->receive(lines.next());
    QVERIFY2(reasonOf(output).contains("faulty/loop hangs: it has not answered for 0.5 s"),
             qPrintable(reasonOf(output)));
    QVERIFY(isSafe(output));
    QTRY_VERIFY(!test::sendSignal(process, 0));
}

void tst_IsolatedBehavior::whatCannotBeStartedSaysWhy_data() {
    QTest::addColumn<QString>("host");
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("words");
    QTest::newRow("no host") << "/nowhere/usar-behavior-host"
                             << "faulty/none"
                             << "Install or build usar-behavior-host";
    QTest::newRow("another program") << "/bin/true"
                                     << "faulty/none"
                                     << "exit code 0";
    QTest::newRow("no such behavior") << program << "faulty/dance"
                                      << "There are: faulty/none";
}

void tst_IsolatedBehavior::whatCannotBeStartedSaysWhy() {
    QFETCH(QString, host);
    QFETCH(QString, id);
    QFETCH(QString, words);
    IsolatedBehavior behavior(host, {plugin.toStdString(), {id.toStdString(), {}, {}, /*plan=*/{}}});
    const auto output = withItsEnd(behavior, behavior.begin());
    QVERIFY2(reasonOf(output).contains(words), qPrintable(reasonOf(output)));
    QVERIFY(behavior.finished());
}

void tst_IsolatedBehavior::itsProcessEndsWithIt() {
    auto behavior = isolated("faulty/none");
    behavior->begin();
    const int process = behavior->processId();
    QVERIFY(test::sendSignal(process, 0));
    behavior.reset();
    QTRY_VERIFY(!test::sendSignal(process, 0));
}

USAR_TEST(tst_IsolatedBehavior)

} // namespace tst_isolated_behavior

#include "tst_isolated_behavior.moc"
