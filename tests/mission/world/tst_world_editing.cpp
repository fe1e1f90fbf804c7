// What is sent for a person's edits of the world, and what can be brought back.
#include <QTest>

#include "core/mission/world/world_editing.h"
#include "tests/suite/suite.h"

namespace tst_world_editing {

using namespace usar;
using namespace usar::mission;

namespace {

/// A slope of one meter in ten along x.
double slope(const Vec2& at_m) {
    return at_m.x() / 10.0;
}

WorldThing thing(const char* name, const char* class_name) {
    WorldThing made{.name = name, .class_name = class_name, .size_m = {}, .body_in_map = {}};
    made.body_in_map.position_m = {10.0, 2.0, 3.0};
    return made;
}

} // namespace

class tst_WorldEditing : public QObject {
    Q_OBJECT
private slots:
    void init() {
        sent.clear();
        ways_changed = 0;
        edits.reset();
        history = std::make_unique<EditHistory>();
        edits = std::make_unique<WorldEditing>(
            *history, WorldEditing::World{[](std::string_view) { return std::optional<Vec3>(Vec3::Ones()); },
                                          [this](const protocol::Command& command) { sent.push_back(command); }, slope,
                                          [this] { ++ways_changed; }});
        edits->inventory().setThings({thing("Crate1", "Crate"), thing("Odd", "")});
    }

    void aNewObjectGetsAFreeNameAndStandsOnTheGround() {
        QCOMPARE(edits->place({"Crate", {}}, {20.0, 0.0}).value(), std::string("Crate2"));
        QCOMPARE(edits->place({"Crate", {}}, {20.0, 0.0}).value(), std::string("Crate3"));
        const auto& created = last<protocol::CreateObject>();
        QCOMPARE(std::get<Pose>(created.start).position_m.z(), 2.0 + 0.5 + 0.02);
        history->undo();
        QCOMPARE(last<protocol::KillObject>().object_name.text(), std::string("Crate3"));
    }

    void aNameThatNoLineCanContainIsRefused() {
        QVERIFY(!edits->place({"two words", {}}, {0.0, 0.0}));
        QVERIFY(sent.empty());
    }

    void aMovedObjectKeepsItsHeightOverTheGround() {
        edits->moveTo("Crate1", {30.0, 5.0});
        QCOMPARE(last<protocol::PlaceObject>().object_in_map.position_m.z(), 5.0);
        history->undo();
        QCOMPARE(last<protocol::PlaceObject>().object_in_map.position_m, Vec3(10.0, 2.0, 3.0));
        sent.clear();
        edits->moveTo("unknown", {30.0, 5.0});
        QVERIFY(sent.empty());
    }

    void turnsAndSpinsAreAboutTheVertical() {
        edits->turn("Crate1", 0.5);
        QCOMPARE(last<protocol::ShiftObject>().shift.yaw_rad, 0.5);
        history->undo();
        QCOMPARE(last<protocol::ShiftObject>().shift.yaw_rad, -0.5);
        edits->toggleSpin("Crate1");
        QVERIFY(!history->canUndo()); // A spin is no step.
        QVERIFY(last<protocol::SpinObject>().rates_rad_s.z() > 0.0);
        edits->toggleSpin("Crate1");
        QCOMPARE(last<protocol::SpinObject>().rates_rad_s.norm(), 0.0);
    }

    void aWayIsKeptUntilItIsCleared() {
        edits->addWaypoint("Crate1", {20.0, 2.0});
        QCOMPARE(edits->inventory().way_m("Crate1").size(), std::size_t(1));
        edits->follow("Crate1", true, {.speed_m_s = 1.0});
        QVERIFY(last<protocol::FollowWaypoints>().moving);
        edits->clearWay("Crate1");
        QVERIFY(edits->inventory().way_m("Crate1").empty());
        edits->follow("Crate1", true, {.speed_m_s = -1.0});
        QCOMPARE(last<protocol::RunConveyor>().speed_m_s, -1.0);
        sent.clear();
        edits->addWaypoint("unknown", {20.0, 2.0});
        QVERIFY(sent.empty());
    }

    void anUndoneWayIsTheFormerOneHereAndInTheWorld() {
        edits->addWaypoint("Crate1", {20.0, 2.0});
        edits->addWaypoint("Crate1", {30.0, 2.0});
        QCOMPARE(last<protocol::AddWaypoints>().points_in_map_m.size(), std::size_t(1)); // Its motion goes on.
        edits->clearWay("Crate1");
        QVERIFY(std::holds_alternative<protocol::ClearWaypoints>(sent.back()));
        QCOMPARE(ways_changed, 3);
        history->undo();
        QCOMPARE(last<protocol::AddWaypoints>().points_in_map_m.size(), std::size_t(2));
        QCOMPARE(edits->inventory().way_m("Crate1").size(), std::size_t(2));
        QCOMPARE(ways_changed, 4);
    }

    void whatCannotBeBroughtBackIsNamed() {
        QVERIFY(edits->remove("unknown").empty());
        QVERIFY(sent.empty());
        QVERIFY(edits->remove("Crate1").empty());
        QVERIFY(history->canUndo());
        edits->clear();
        QVERIFY(!history->canUndo());
        QCOMPARE(edits->remove("Odd"), std::vector<std::string>{"Odd"});
        QVERIFY(!history->canUndo());
        QCOMPARE(edits->removeAll(), std::vector<std::string>{"Odd"});
        QVERIFY(std::holds_alternative<protocol::KillAllObjects>(sent.back()));
    }

private:
    template <class Command>
    const Command& last() const {
        return std::get<Command>(sent.back());
    }

    std::vector<protocol::Command> sent;
    std::unique_ptr<EditHistory> history;
    std::unique_ptr<WorldEditing> edits;
    int ways_changed = 0;
};

USAR_TEST(tst_WorldEditing)

} // namespace tst_world_editing

#include "tst_world_editing.moc"
