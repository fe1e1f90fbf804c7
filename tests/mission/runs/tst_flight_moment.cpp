// Moments of recordings: what a test of them flies, and what they say about claims.
#include <algorithm>
#include <atomic>

#include <QTemporaryDir>
#include <QTest>

#include "core/agent/published_text.h"
#include "core/link/recording_writer.h"
#include "core/mission/claims/claim_watch.h"
#include "core/mission/runs/flight_moment.h"
#include "core/protocol/reader.h"
#include "tests/doubles/plan_trace.h"
#include "tests/suite/suite.h"

namespace tst_flight_moment {

using namespace usar;
using namespace usar::mission;

namespace {

const std::string rover = "((DC rover (drives ((danger (trigger ((near))) back)) ((way go)))))";

/// A recording that a test writes record by record.
class Tape {
public:
    Tape() : writer_(*link::RecordingWriter::create(path(), {{"robot", "R1"}}, {})) { opened(); }

    QString path() const { return folder_.filePath("r.usarrec"); }
    void opened() { writer_->write({.kind = link::RecordKind::Opened, .bytes = "localhost:3000"}); }
    /// The robot reports this time and, by INS, this height.
    void at(double now_s, double z_m) {
        const std::string text = "STA {Type AerialVehicle} {Time " + std::to_string(now_s) + "} {Battery 1200}\r\n" +
                                 "SEN {Type INS} {Name INS} {Location 0,0," + std::to_string(-z_m) +
                                 "} {Orientation 0,0,0}\r\n";
        writer_->write({.kind = link::RecordKind::In, .line = {lines_}, .bytes = text});
        lines_ += 2;
        for (const std::string& line : {text.substr(0, text.find('\r')), text.substr(text.find('\n') + 1)})
            if (watch)
                watch->take(reader_.read(line), Seconds{now_s});
        if (begun_s_ && !doing.empty())
            state(now_s, now_s - *begun_s_, doing);
    }
    /// From one time to the other, five times a second, at one height.
    void fly(double from_s, double to_s, double z_m) {
        for (double now_s = from_s; now_s <= to_s; now_s += 0.2)
            at(now_s, z_m);
    }
    void note(const char* name, const std::string& text) {
        writer_->write({.kind = link::RecordKind::Note, .line = {lines_}, .name = name, .bytes = text});
    }
    void begin(double now_s, std::vector<std::string> faults = {}) {
        FlownMission flown;
        flown.mission.name = "Flight";
        flown.mission.faults = std::move(faults);
        flown.seed = 7;
        note("mission", noteOf(flown));
        begun_s_ = now_s;
        state(now_s, 0.0, "starting");
    }
    void state(double now_s, double elapsed_s, const std::string& words) {
        agent::BehaviorStatus status;
        status.time = Seconds{now_s};
        status.elapsed = Seconds{elapsed_s};
        status.state = words;
        publish(status);
    }
    void publish(const agent::Published& value) {
        std::string text;
        agent::appendText(text, value);
        note("published", text);
        if (watch)
            watch->take(value);
    }
    void drive(const char* who) {
        writer_->write({.kind = link::RecordKind::Out, .line = {lines_}, .name = who, .bytes = "DRIVE {Left 1}\r\n"});
    }

    ClaimWatch* watch = nullptr; ///< It takes what is recorded, as in a test that flies it.
    std::string doing;           ///< The behavior publishes this state whenever the robot reports; empty: none.

    Result<FlightMoment> moment(double now_s) {
        writer_.reset();
        return readFlightMoment(path(), Seconds{now_s}, std::atomic_bool(false));
    }

private:
    QTemporaryDir folder_;
    std::unique_ptr<link::RecordingWriter> writer_;
    std::uint64_t lines_ = 0; ///< They were received so far.
    std::optional<double> begun_s_;
    protocol::Reader reader_;
};

Claim claim(ClaimKind kind, double from_s, double to_s, double height_m = 0.0, const std::string& name = {}) {
    return {kind, Seconds{from_s}, Seconds{to_s}, height_m, name};
}

bool offers(const FlightMoment& moment, const Claim& wanted) {
    const auto all = claimsToOffer(moment, wanted.from, wanted.to);
    return std::ranges::find(all, wanted) != all.end();
}

} // namespace

class tst_FlightMoment : public QObject {
    Q_OBJECT
private slots:
    /// Somebody spawned the robot, waited for a minute, and pressed Start.
    void timesAndHeightsCountFromTheStartOfTheBehavior() {
        Tape tape;
        tape.fly(1.0, 60.0, 10.0);
        tape.begin(60.0);
        tape.fly(60.2, 70.0, 12.0);
        tape.fly(70.2, 90.0, 15.0);
        const auto moment = tape.moment(80.0);
        QVERIFY2(moment, moment ? "" : moment.error().text().c_str());
        QCOMPARE(moment->at.count(), 20.0);
        QVERIFY(moment->late && !moment->by_hand);
        QVERIFY(heldIn(*moment, claim(ClaimKind::AltitudeAbove, 15.0, 20.0, 2.9)) == true);
        QVERIFY(heldIn(*moment, claim(ClaimKind::AltitudeAbove, 15.0, 20.0, 3.1)) == false);
        QVERIFY(offers(*moment, claim(ClaimKind::AltitudeAbove, 15.0, 20.0, 1.5))); // with a meter for other drift
        QVERIFY(offers(*moment, claim(ClaimKind::AltitudeBelow, 15.0, 20.0, 4.5)));
        const Mission test = testOf(*moment, claim(ClaimKind::NoContact, 20.0, 30.0), "One");
        QCOMPARE(test.name, std::string("One"));
        QVERIFY(test.seed == std::uint64_t(7) && test.claims.size() == 1);
    }

    void aFlightThatIsRepeatedRoughlyGetsSlack_data() {
        QTest::addColumn<bool>("late");
        QTest::newRow("the behavior started with the robot") << false;
        QTest::newRow("the behavior started later") << true;
    }
    void aFlightThatIsRepeatedRoughlyGetsSlack() {
        QFETCH(bool, late);
        Tape tape;
        if (late)
            tape.fly(1.0, 60.0, 10.0);
        tape.begin(60.0);
        tape.fly(60.2, 80.0, 12.0);
        tape.doing = "scanning";
        tape.fly(80.2, 99.9, 15.0);
        tape.doing = "landing";
        tape.fly(100.0, 110.0, 15.0);
        const auto moment = tape.moment(90.0);
        QVERIFY(moment);
        QCOMPARE(isRepeatedRoughly(*moment), late);
        const std::vector<Claim> all = claimsToOffer(*moment, Seconds{25.0}, Seconds{35.0});
        QCOMPARE(all.front().kind, late ? ClaimKind::NoContact : ClaimKind::AltitudeAbove);
        QVERIFY(offers(*moment, claim(ClaimKind::AltitudeAbove, 25.0, 35.0, late ? 1.5 : 2.5)));
        const Claim state = late ? claim(ClaimKind::State, 15.0, 45.0, 0.0, "scanning")
                                 : claim(ClaimKind::State, 25.0, 35.0, 0.0, "scanning");
        QVERIFY(std::ranges::find(all, state) != all.end());
        // It is in the wider time, but nobody saw it in the time that was chosen.
        QVERIFY(std::ranges::none_of(all, [](const Claim& one) { return one.name == "landing"; }));
    }

    void faultsAreThoseOfTheTestsOwnTime() {
        Tape tape;
        tape.fly(1.0, 60.0, 10.0);
        tape.note("fault", "30.0 s: fault begins: fog from=30");
        tape.begin(60.0, {"late from=500"});
        tape.fly(60.2, 70.0, 12.0);
        tape.note("fault", "70.0 s: fault begins: wind speed=5 from=70");
        tape.fly(70.2, 75.0, 12.0);
        tape.note("fault", "75.0 s: fault ends: wind speed=5 from=70");
        tape.note("fault", "75.0 s: fault begins: rotor robot=R2 from=75");
        tape.note("fault", "75.0 s: fault begins: hang robot=R1 sensor=INS from=75 for=3");
        tape.fly(75.2, 90.0, 12.0);
        const auto moment = tape.moment(80.0);
        QVERIFY(moment);
        const std::vector<std::string> expected{"fog", "wind speed=5 from=10.00 for=5.00",
                                                "hang sensor=INS for=3 from=15.00", "late from=500"};
        QCOMPARE(moment->flown.mission.faults, expected);
    }

    void whatWasNotFlownIsNotSaidToHaveHeld() {
        Tape tape;
        tape.begin(1.0);
        tape.fly(1.2, 20.0, 10.0);
        for (const std::string& piece : test::piecesOf(rover, 50))
            tape.publish(agent::PlanTrace{piece});
        const auto moment = tape.moment(20.0); // The flight goes on; this is all that is recorded.
        QVERIFY(moment);
        for (const Claim& one : claimsToOffer(*moment, Seconds{19.0}, Seconds{29.0}))
            QVERIFY2(one.kind == ClaimKind::State || !heldIn(*moment, one), sentenceOf(one).c_str());
        QVERIFY(heldIn(*moment, claim(ClaimKind::ElementRuns, 1.0, 9.0, 0.0, "go")) == true);
        QVERIFY(heldIn(*moment, claim(ClaimKind::ElementRests, 1.0, 9.0, 0.0, "go")) == false);
        QVERIFY(heldIn(*moment, claim(ClaimKind::ElementRests, 1.0, 9.0, 0.0, "danger")) == true);
        QVERIFY(!heldIn(*moment, claim(ClaimKind::NoContact, 1.0, 9.0)));
    }

    void aStateIsClaimedWhereItWasPublished() {
        Tape tape;
        tape.begin(1.0);
        tape.doing = "scanning lane 1";
        tape.fly(5.0, 14.9, 10.0);
        tape.doing = "landing";
        tape.fly(15.0, 20.0, 10.0);
        const auto moment = tape.moment(10.0);
        QVERIFY(moment);
        QVERIFY(heldIn(*moment, claim(ClaimKind::State, 8.0, 12.0, 0.0, "Lane 1")) == true);
        QVERIFY(heldIn(*moment, claim(ClaimKind::State, 15.0, 17.0, 0.0, "Lane 1")) == false);
        QVERIFY(offers(*moment, claim(ClaimKind::State, 8.0, 12.0, 0.0, "scanning lane 1")));
        QVERIFY(!offers(*moment, claim(ClaimKind::State, 8.0, 12.0, 0.0, "landing")));
    }

    void theMissionIsThatOfTheMoment_data() {
        QTest::addColumn<double>("now_s");
        QTest::addColumn<double>("at_s");
        QTest::newRow("the first") << 15.0 << 14.0;
        QTest::newRow("the second") << 30.0 << 10.0;
    }

    void theMissionIsThatOfTheMoment() {
        QFETCH(double, now_s);
        QFETCH(double, at_s);
        Tape tape;
        tape.begin(1.0);
        tape.fly(1.2, 18.0, 10.0);
        tape.drive("by hand: keys");
        tape.fly(18.2, 20.0, 10.0);
        tape.begin(20.0);
        tape.fly(20.2, 40.0, 10.0);
        const auto moment = tape.moment(now_s);
        QVERIFY(moment);
        QCOMPARE(moment->at.count(), at_s);
        QCOMPARE(moment->by_hand, now_s > 18.0);
        QVERIFY(moment->last.count() >= at_s && moment->last.count() < 21.0);
    }

    /// The robot reports heights up to 10 s and from 20 s on, both times 5 m above its place.
    void theWordOnHeightsIsThatOfTheRunner_data() {
        QTest::addColumn<Claim>("one");
        QTest::addColumn<int>("held"); // -1: not recorded
        QTest::addColumn<bool>("holds");
        QTest::newRow("it was above") << claim(ClaimKind::AltitudeAbove, 3.0, 8.0, 4.0) << 1 << true;
        QTest::newRow("it was not above") << claim(ClaimKind::AltitudeAbove, 3.0, 8.0, 6.0) << 0 << false;
        QTest::newRow("it was below") << claim(ClaimKind::AltitudeBelow, 22.0, 28.0, 6.0) << 1 << true;
        QTest::newRow("partly silent") << claim(ClaimKind::AltitudeAbove, 8.0, 15.0, 4.0) << 1 << true;
        QTest::newRow("silent, above") << claim(ClaimKind::AltitudeAbove, 12.0, 18.0, 4.0) << -1 << false;
        QTest::newRow("silent, below") << claim(ClaimKind::AltitudeBelow, 12.0, 18.0, 6.0) << -1 << false;
    }

    void theWordOnHeightsIsThatOfTheRunner() {
        QFETCH(Claim, one);
        Tape tape;
        ClaimWatch watch({one});
        tape.watch = &watch;
        tape.begin(1.0);
        tape.fly(1.2, 2.0, 10.0);
        tape.fly(2.2, 11.0, 15.0);
        tape.fly(21.0, 31.0, 15.0);
        watch.end();
        const auto moment = tape.moment(25.0);
        QVERIFY(moment);
        const auto held = heldIn(*moment, one);
        QTEST(held ? static_cast<int>(*held) : -1, "held");
        QTEST(watch.allHold(), "holds");
    }

    /// The robot is silent from 10 s to 20 s, so the behavior publishes nothing; it scans before that and lands after
    /// it.
    void theWordOnStatesIsThatOfTheRunner_data() {
        QTest::addColumn<Claim>("one");
        QTest::addColumn<int>("held"); // -1: not recorded
        QTest::addColumn<bool>("holds");
        const auto state = [](double from_s, double to_s, const char* words) {
            return claim(ClaimKind::State, from_s, to_s, 0.0, words);
        };
        QTest::newRow("it was seen") << state(3.0, 8.0, "scanning") << 1 << true;
        QTest::newRow("another was seen") << state(3.0, 8.0, "landing") << 0 << false;
        QTest::newRow("seen before the silence") << state(8.0, 15.0, "scanning") << 1 << true;
        QTest::newRow("seen after the silence") << state(15.0, 22.0, "landing") << 1 << true;
        QTest::newRow("not seen beside the silence") << state(15.0, 22.0, "scanning") << 0 << false;
        QTest::newRow("silent") << state(12.0, 18.0, "scanning") << -1 << false;
        QTest::newRow("the recording ends first") << state(26.0, 40.0, "scanning") << -1 << false;
        QTest::newRow("seen before the recording ends") << state(26.0, 40.0, "landing") << 1 << true;
    }

    void theWordOnStatesIsThatOfTheRunner() {
        QFETCH(Claim, one);
        Tape tape;
        ClaimWatch watch({one});
        tape.watch = &watch;
        tape.begin(1.0);
        tape.doing = "scanning";
        tape.fly(1.2, 11.0, 15.0);
        tape.doing = "landing";
        tape.fly(21.0, 31.0, 15.0);
        watch.end();
        const auto moment = tape.moment(25.0);
        QVERIFY(moment);
        const auto held = heldIn(*moment, one);
        QTEST(held ? static_cast<int>(*held) : -1, "held");
        QTEST(watch.allHold(), "holds");
        QVERIFY(held == true || !offers(*moment, one)); // Only what was seen is offered.
    }

    /// The plan's element go runs all the time, danger never does; the flight ends with the recording, at 29 s.
    void theWordOnElementsIsThatOfTheRunner_data() {
        QTest::addColumn<Claim>("one");
        QTest::addColumn<int>("held"); // -1: not recorded
        QTest::addColumn<bool>("holds");
        const auto element = [](ClaimKind kind, double from_s, double to_s, const char* name) {
            return claim(kind, from_s, to_s, 0.0, name);
        };
        QTest::newRow("it ran") << element(ClaimKind::ElementRuns, 1.0, 9.0, "go") << 1 << true;
        QTest::newRow("it did not rest") << element(ClaimKind::ElementRests, 1.0, 9.0, "go") << 0 << false;
        QTest::newRow("it rested") << element(ClaimKind::ElementRests, 1.0, 9.0, "danger") << 1 << true;
        QTest::newRow("its last piece may be missing")
            << element(ClaimKind::ElementRests, 20.0, 27.0, "danger") << -1 << false;
        QTest::newRow("it may have run in the last piece")
            << element(ClaimKind::ElementRuns, 20.0, 27.0, "danger") << -1 << false;
    }

    void theWordOnElementsIsThatOfTheRunner() {
        QFETCH(Claim, one);
        Tape tape;
        ClaimWatch watch({one});
        tape.watch = &watch;
        tape.begin(1.0);
        tape.fly(1.2, 5.0, 15.0);
        for (const std::string& piece : test::piecesOf(rover, 50))
            tape.publish(agent::PlanTrace{piece});
        tape.fly(5.2, 30.0, 15.0);
        watch.end();
        const auto moment = tape.moment(25.0);
        QVERIFY(moment);
        const auto held = heldIn(*moment, one);
        QTEST(held ? static_cast<int>(*held) : -1, "held");
        QTEST(watch.allHold(), "holds");
    }

    void aConnectionAfterTheMomentChangesNothing() {
        Tape tape;
        tape.begin(1.0);
        tape.fly(1.2, 20.0, 10.0);
        tape.opened();
        tape.fly(0.2, 5.0, 30.0);
        const auto moment = tape.moment(15.0);
        QVERIFY(moment);
        QCOMPARE(moment->at.count(), 14.0);
        QVERIFY(heldIn(*moment, claim(ClaimKind::AltitudeBelow, 5.0, 15.0, 5.0)) == true);
    }

    void aMomentWithoutAMissionIsRefused() {
        Tape tape;
        tape.fly(1.0, 10.0, 10.0);
        tape.begin(10.0);
        tape.fly(10.2, 20.0, 10.0);
        const auto moment = tape.moment(5.0);
        QVERIFY(!moment);
        QVERIFY2(moment.error().text().find("r.usarrec") != std::string::npos, moment.error().text().c_str());
    }
};

USAR_TEST(tst_FlightMoment)

} // namespace tst_flight_moment

#include "tst_flight_moment.moc"
