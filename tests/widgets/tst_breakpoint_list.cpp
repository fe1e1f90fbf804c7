// Breakpoints as a person sets, reads and keeps them.
#include <QTest>

#include "tests/suite/suite.h"
#include "tests/widgets/plan_samples.h"
#include "widgets/models/plan/breakpoint_list.h"

namespace tst_breakpoint_list {

using namespace usar;
using namespace usar::widgets;
using agent::BreakpointId;
using posh::BreakOn;
using posh::Breakpoint;

namespace {

Breakpoint at(const std::string& names, BreakOn on = BreakOn::Before) {
    Breakpoint breakpoint;
    breakpoint.names = names;
    breakpoint.on = on;
    return breakpoint;
}

} // namespace

class tst_BreakpointList : public QObject {
    Q_OBJECT
private slots:
    void numbersAreNeverGivenTwice();
    void eachPlanHasItsOwn();
    void comesBackFromWhatWasKept();
    void whatIsNoneIsLeftOut();
    void placesAreFoundAgainInAChangedPlan();
    void aSecondTimeRemovesWhatTheFirstSet();
    void allAreSwitchedTogether();
    void temporaryOnesEndWithTheHalt();
    void theListOfAPlanNamesWhatIsLost();
    void sentences_data();
    void sentences();
};

void tst_BreakpointList::numbersAreNeverGivenTwice() {
    BreakpointList list;
    const BreakpointId first = list.add(at("d ▸ a"));
    list.remove(first);
    const BreakpointId second = list.add(at("d ▸ b"));
    QVERIFY(first != second);
    QVERIFY(!list.find(first));
    QCOMPARE(list.find(second)->names, std::string("d ▸ b"));
    list.change(second, at("d ▸ c"));
    QCOMPARE(list.find(second)->names, std::string("d ▸ c"));
    list.change(first, at("nobody"));
    QCOMPARE(list.all().size(), std::size_t(1));
}

void tst_BreakpointList::eachPlanHasItsOwn() {
    BreakpointList list;
    const BreakpointId air = list.add(at("Air ▸ work"));
    list.add(at("AirRobot ▸ work"));
    const BreakpointId root = list.add(at("Air"));
    QCOMPARE(list.ofPlan("Air"), (std::vector<BreakpointId>{air, root}));
    Breakpoint placed = at("Air ▸ rest");
    placed.path = "/P:0/DC:0/DE:1";
    const BreakpointId rest = list.add(placed);
    QCOMPARE(list.atPath("Air", placed.path), std::vector<BreakpointId>{rest});
    QVERIFY(list.atPath("AirRobot", placed.path).empty());
}

void tst_BreakpointList::comesBackFromWhatWasKept() {
    BreakpointList list;
    Breakpoint all = at("d ▸ \"a\" é", BreakOn::Result);
    all.path = "/P:0/DC:0/DE:0";
    all.result = posh::ActResult::RunningOnce;
    all.condition = "(near 0.3 <) (far)";
    all.skip = 41;
    all.once = true;
    all.enabled = false;
    list.add(all);
    for (const BreakOn on : {BreakOn::Before, BreakOn::After, BreakOn::VerdictChange, BreakOn::Interruption})
        list.add(at("d ▸ b", on));
    const BreakpointList kept = BreakpointList::fromJson(list.toJson());
    QCOMPARE(kept.all().size(), list.all().size());
    for (std::size_t i = 0; i < kept.all().size(); ++i)
        QVERIFY(kept.all()[i].what == list.all()[i].what);
}

void tst_BreakpointList::whatIsNoneIsLeftOut() {
    QVERIFY(BreakpointList::fromJson("").all().empty());
    const char* const none = R"([1, {}, {"names": "d"}, {"on": "before"},
                                 {"names": "d", "on": "before", "condition": "(near"}])";
    QVERIFY(BreakpointList::fromJson(none).all().empty());
    const char* const one = R"([{"names": "d", "on": "before", "skip": -3}, 7])";
    QCOMPARE(BreakpointList::fromJson(one).all().size(), std::size_t(1));
}

void tst_BreakpointList::placesAreFoundAgainInAChangedPlan() {
    const auto program = posh::compile(planOf("((DC d (drives ((new sing)) ((a walk)))))"));
    QVERIFY(program);
    BreakpointList list;
    Breakpoint moved = at("d ▸ a");
    moved.path = "/P:0/DC:0/DE:0";
    Breakpoint gone = at("d ▸ b");
    gone.path = "/P:0/DC:0/DE:1";
    Breakpoint other = at("e ▸ a");
    other.path = "/P:0/DC:0/DE:0";
    list.add(moved);
    list.add(gone);
    list.add(other);
    list.repairPaths(**program);
    QCOMPARE(list.all()[0].what.path, std::string("/P:0/DC:0/DE:1"));
    QCOMPARE(list.all()[1].what.path, std::string());
    QCOMPARE(list.all()[2].what.path, other.path); // of another plan
}

void tst_BreakpointList::aSecondTimeRemovesWhatTheFirstSet() {
    const auto program = *posh::compile(planOf("((DC d (drives ((a walk)) ((b sing)))))"));
    const std::vector<PlanSpot> spots{{.path = "/P:0/DC:0/DE:0", .names = "d ▸ a", .call = {}},
                                      {.path = "/P:0/DC:0/DE:1", .names = "d ▸ b", .call = {}}};
    BreakpointList list;
    list.toggle("d", spots, BreakOn::Before);
    list.toggle("d", {spots.front()}, BreakOn::After);
    list.toggleKey(*program, "lane");
    QCOMPARE(list.atSpots("d", spots).size(), std::size_t(3));
    QCOMPARE(list.atSpots("d", spots, BreakOn::After).size(), std::size_t(1));
    QVERIFY(list.atSpots("e", spots).empty());
    QCOMPARE(list.ofKey("d", "lane").size(), std::size_t(1));
    list.toggle("d", spots, BreakOn::After); // of one of the two places
    list.toggleKey(*program, "lane");
    QCOMPARE(list.all().size(), std::size_t(2));
    list.toggle("d", {spots.back()}, BreakOn::Before);
    QCOMPARE(list.all().size(), std::size_t(1));
    QCOMPARE(list.all().front().what.names, std::string("d ▸ a"));
    list.remove(list.ofPlan("d"));
    QVERIFY(list.all().empty());
}

void tst_BreakpointList::allAreSwitchedTogether() {
    BreakpointList list;
    const std::vector<BreakpointId> ids{list.add(at("d ▸ a")), list.add(at("d ▸ b"))};
    list.enable(ids.front(), false);
    list.enable({99}, false);
    list.toggleEnabled(ids);
    QVERIFY(!list.find(ids.front())->enabled && !list.find(ids.back())->enabled);
    list.toggleEnabled(ids);
    QVERIFY(list.find(ids.front())->enabled && list.find(ids.back())->enabled);
}

void tst_BreakpointList::temporaryOnesEndWithTheHalt() {
    BreakpointList list;
    Breakpoint once = at("d ▸ a");
    once.once = true;
    const BreakpointId lasting = list.add(once);
    PlanSpot spot;
    spot.names = "d ▸ b";
    list.setTemporary({spot});
    list.setTemporary({spot}); // replaces the first
    QCOMPARE(list.all().size(), std::size_t(2));
    QCOMPARE(BreakpointList::fromJson(list.toJson()).all().size(), std::size_t(1));
    list.takeHit(lasting);
    QVERIFY(!list.find(lasting)->enabled);
    QVERIFY(list.dropTemporary());
    QVERIFY(!list.dropTemporary());
    QCOMPARE(list.all().size(), std::size_t(1));
}

void tst_BreakpointList::theListOfAPlanNamesWhatIsLost() {
    BreakpointList list;
    Breakpoint key = at("d", BreakOn::Written);
    key.key = "height";
    key.path = "/DC";
    list.add(key);
    list.add(at("d ▸ a"));
    list.add(at("other ▸ a"));
    const auto rows = list.rowsOfPlan("d");
    QCOMPARE(rows.size(), std::size_t(2));
    QCOMPARE(rows[0].help, QStringLiteral("d"));
    QVERIFY(rows[1].path.empty());
    QVERIFY(rows[1].help.contains(QStringLiteral("no such place")));
    QCOMPARE(list.keysOfPlan("d"), QStringList(QStringLiteral("height")));
    QVERIFY(list.keysOfPlan("other").isEmpty());
    QVERIFY(list.rowsOfPlan("").empty());
}

void tst_BreakpointList::sentences_data() {
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("plain") << QByteArray(R"({"names": "d ▸ work", "on": "before"})") << "work, before";
    QTest::newRow("full")
        << QByteArray(R"json({"names": "d", "on": "after", "condition": "(near)", "skip": 3, "once": true})json")
        << "d, after, if (near), from hit 4 on, once";
    QTest::newRow("an answer") << QByteArray(R"({"names": "d ▸ a", "on": "result", "result": "Running"})")
                               << "a, when it answers: still running";
}

void tst_BreakpointList::sentences() {
    QFETCH(QByteArray, json);
    QFETCH(QString, sentence);
    const BreakpointList list = BreakpointList::fromJson("[" + json + "]");
    QCOMPARE(list.all().size(), std::size_t(1));
    QCOMPARE(breakpointText(list.all().front().what), sentence);
}

USAR_TEST(tst_BreakpointList)

} // namespace tst_breakpoint_list

#include "tst_breakpoint_list.moc"
