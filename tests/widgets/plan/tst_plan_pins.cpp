// The places of a drawn part, what is pinned there, and the marks of all that a user does to a run.
#include <QTest>

#include "tests/suite/suite.h"
#include "tests/widgets/plan_samples.h"
#include "widgets/models/plan/plan_marks.h"
#include "widgets/models/plan/plan_spots.h"

namespace tst_plan_pins {

using namespace usar;
using namespace usar::widgets;
using posh::ActResult;

namespace {

/// The pattern `halt` is used twice, and so is its act.
constexpr std::string_view plan_text =
    "((AP halt (Stop)) (DC d (drives ((safe (trigger ((near 0.3 <))) halt)) ((work halt)))))";

struct Run {
    posh::Plan plan = planOf(plan_text);
    PlanTree tree{plan};
    std::shared_ptr<const posh::Program> program = *posh::compile(plan);
    std::vector<std::string> paths = [this] {
        std::vector<std::string> all;
        for (posh::Index place = 0; place < program->places.size(); ++place)
            all.push_back(posh::pathOf(*program, place));
        return all;
    }();

    std::vector<PlanSpot> spots(std::string_view names) const {
        const PlanNodeId node = tree.find(posh::pathOf(*program, posh::findPlace(*program, {}, std::string(names))));
        return spotsOfNode(*program, paths, tree, tree[node].link.valid() ? tree[node].link : node);
    }
    PlanSpot spot(std::string_view names) const { return spots(names).front(); }
};

const PlanMark* markOf(const std::vector<PlanMark>& marks, const std::string& path) {
    const auto found = std::ranges::find(marks, path, &PlanMark::path);
    return found == marks.end() ? nullptr : &*found;
}

} // namespace

class tst_PlanPins : public QObject {
    Q_OBJECT
private slots:
    void spotsSayHowBreakpointsReferToThem();
    void nothingSelectedHasNoSpots();
    void aPinIsReleasedByItsCall();
    void aDriveIsSwitchedOffAndOn();
    void pinsAreMarkedWhereverTheCallIsMade();
    void breakpointsAreMarkedAtTheirPlaces();
};

void tst_PlanPins::spotsSayHowBreakpointsReferToThem() {
    const Run run;
    const PlanSpot sense = run.spot("d ▸ safe ▸ near");
    QCOMPARE(sense.kind, posh::PlaceKind::Sense);
    QCOMPARE(sense.names, std::string("d ▸ safe ▸ near"));
    QCOMPARE(sense.call, std::string("near"));
    QCOMPARE(sense.path, run.paths[posh::findPlace(*run.program, {}, sense.names)]);
    QCOMPARE(run.spot("d ▸ work").kind, posh::PlaceKind::Drive);
    QVERIFY(run.spot("d ▸ work").call.empty());
    const std::vector<PlanSpot> stops = run.spots("d ▸ safe ▸ halt ▸ Stop"); // drawn once for both drives
    QCOMPARE(stops.size(), std::size_t(2));
    QCOMPARE(stops.front().call, std::string("Stop"));
    QCOMPARE(stops.back().names, std::string("d ▸ work ▸ halt ▸ Stop"));
}

void tst_PlanPins::nothingSelectedHasNoSpots() {
    const Run run;
    QVERIFY(spotsOfNode(*run.program, run.paths, run.tree, {}).empty());
    QVERIFY(spotsOfNode(*run.program, {}, run.tree, {0}).empty());
}

void tst_PlanPins::aPinIsReleasedByItsCall() {
    const PlanSpot sense{.path = "/a", .names = "d ▸ a ▸ near", .call = "near", .kind = posh::PlaceKind::Sense};
    const PlanSpot act{.path = "/b", .names = "d ▸ a ▸ near", .call = "near", .kind = posh::PlaceKind::Act};
    PlanPins pins;
    QVERIFY(pins.empty() && !pins.release(sense) && !pins.release(act));
    pins.pinSense("near", 0.5);
    pins.pinAct("near", ActResult::Running);
    QVERIFY((pins.all() == agent::SetPins{{{"near", 0.5}}, {{"near", ActResult::Running}}, {}}));
    QVERIFY(pins.release(sense));
    QVERIFY(pins.all().senses.empty() && pins.all().acts.size() == 1);
    QVERIFY(!pins.release(sense) && pins.release(act) && pins.empty());
}

void tst_PlanPins::aDriveIsSwitchedOffAndOn() {
    const Run run;
    PlanPins pins;
    pins.toggleDrive(run.spot("d ▸ work"));
    pins.toggleDrive(run.spot("d ▸ safe"));
    QCOMPARE(pins.all().drives_off.size(), std::size_t(2));
    pins.toggleDrive(run.spot("d ▸ work"));
    QCOMPARE(pins.all().drives_off.size(), std::size_t(1));
    QCOMPARE(pins.all().drives_off.front().names, std::string("d ▸ safe"));
}

void tst_PlanPins::pinsAreMarkedWhereverTheCallIsMade() {
    const Run run;
    PlanPins pins;
    pins.pinSense("near", 0.5);
    pins.pinAct("Stop", ActResult::Failed);
    pins.toggleDrive(run.spot("d ▸ work"));
    std::vector<PlanMark> marks;
    markPins(pins.all(), *run.program, run.paths, marks);
    QCOMPARE(std::ranges::count_if(marks, &PlanMark::pinned), 3); // the sense, and the act at both of its places
    const PlanMark* const sense = markOf(marks, run.spot("d ▸ safe ▸ near").path);
    QVERIFY(sense);
    QCOMPARE(sense->words, QStringList{"Forced: 0.5"});
    const PlanMark* const drive = markOf(marks, run.spot("d ▸ work").path);
    QVERIFY(drive && drive->switched_off && !drive->pinned);
    markHalt(drive->path, marks);
    QVERIFY(markOf(marks, run.spot("d ▸ work").path)->halted);
    QCOMPARE(marks.size(), std::size_t(4));
    QCOMPARE(markOf(marks, run.spot("d ▸ work").path)->words,
             (QStringList{"Switched off by the user", "The plan is halted here"}));
}

void tst_PlanPins::breakpointsAreMarkedAtTheirPlaces() {
    const Run run;
    const std::vector<PlanSpot> work{run.spot("d ▸ work")};
    BreakpointList list;
    list.toggle("d", work, posh::BreakOn::Before);
    list.toggle("d", work, posh::BreakOn::After);
    list.enable(list.atSpots("d", work, posh::BreakOn::After).front(), false);
    list.toggleKey(*run.program, "lane");
    list.add({.path = "", .names = "d ▸ gone", .condition = {}});
    std::vector<PlanMark> marks;
    markBreakpoints(list, "d", marks);
    QCOMPARE(marks.size(), std::size_t(1));
    QCOMPARE(marks.front().breakpoints, 1);
    QCOMPARE(marks.front().breakpoints_off, 1);
    QVERIFY(!marks.front().conditional);
    QCOMPARE(marks.front().words, (QStringList{"Breakpoint: before", "Breakpoint, off: after"}));
    markBreakpoints(list, "e", marks);
    QCOMPARE(marks.size(), std::size_t(1));
}

USAR_TEST(tst_PlanPins)

} // namespace tst_plan_pins

#include "tst_plan_pins.moc"
