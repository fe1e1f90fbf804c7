#include <QTest>

#include "core/mission/session/update_feed.h"
#include "tests/suite/suite.h"

namespace tst_update_feed {

using namespace usar;
using namespace usar::mission;

namespace {

struct Shown {
    void addLine() { feed.addLine({{1}, "STA", protocol::RobotState{}, {}}); }

    bool is_observed = true;
    std::vector<std::shared_ptr<const SessionUpdate>> updates;
    QObject thread_owner;
    std::shared_ptr<const std::vector<Vec2>> corrected_m;
    ScanMapper mapper{0.25};
    UpdateFeed feed{thread_owner, [this] { return is_observed; },
                    [this] { updates.push_back(feed.take(mapper, SessionFigures{}, corrected_m)); }};
};

} // namespace

class tst_UpdateFeed : public QObject {
    Q_OBJECT
private slots:
    void manyChangesAreOneUpdate() {
        Shown shown;
        shown.feed.lookForObservers();
        for (int i = 0; i < 3; ++i) {
            shown.addLine();
            shown.feed.touched();
        }
        QVERIFY(shown.updates.empty());
        QTRY_COMPARE(shown.updates.size(), std::size_t(1));
        QCOMPARE(shown.updates.front()->lines.size(), std::size_t(3));
    }

    void withoutObserversNothingIsCollected() {
        Shown shown;
        shown.is_observed = false;
        shown.feed.lookForObservers();
        shown.addLine();
        shown.feed.touched();
        shown.feed.showNow();
        QVERIFY(shown.updates.empty());
        shown.is_observed = true;
        shown.feed.lookForObservers();
        shown.feed.showNow();
        QCOMPARE(shown.updates.size(), std::size_t(1));
        QVERIFY(shown.updates.front()->lines.empty());
    }

    void theLastUpdateDoesNotWait() {
        Shown shown;
        shown.feed.lookForObservers();
        shown.feed.addCommand({protocol::Step{}, {by::Other{"test"}, {4}}}, "STEP", {5}, Seconds{1.5});
        shown.feed.addPublished({agent::MapMark{}});
        shown.feed.touched();
        shown.feed.showNow();
        QCOMPARE(shown.updates.size(), std::size_t(1));
        QCOMPARE(shown.updates.front()->published.size(), std::size_t(1));
        const SentCommand& sent = shown.updates.front()->commands.at(0);
        QCOMPARE(sent.text, std::string("STEP"));
        QCOMPARE(sent.after, LineNumber{5});
        QCOMPARE(sent.time.count(), 1.5);
    }

    void whileMutedUpdatesAreCollectedOnly() {
        Shown shown;
        shown.feed.lookForObservers();
        shown.feed.mute(true);
        shown.addLine();
        shown.feed.touched();
        shown.feed.showNow();
        QVERIFY(shown.updates.empty());
        shown.feed.mute(false);
        shown.feed.touched();
        QTRY_COMPARE(shown.updates.size(), std::size_t(1));
        QCOMPARE(shown.updates.front()->lines.size(), std::size_t(1));
    }

    void allUpdatesShareTheCorrectedPath() {
        Shown shown;
        shown.feed.lookForObservers();
        shown.corrected_m = std::make_shared<const std::vector<Vec2>>(3, Vec2(1.0, 2.0));
        shown.feed.showNow();
        shown.feed.showNow();
        QVERIFY(shown.updates.at(0)->corrected_path_m == shown.corrected_m);
        QVERIFY(shown.updates.at(1)->corrected_path_m == shown.corrected_m);
        shown.corrected_m.reset();
        shown.feed.showNow();
        QVERIFY(!shown.updates.at(2)->corrected_path_m);
    }

    void aRewoundUpdateSaysSo() {
        Shown shown;
        shown.feed.lookForObservers();
        shown.addLine();
        shown.feed.rewind();
        shown.feed.addTask({"airrobot/cpp", {}});
        shown.feed.showNow();
        QVERIFY(shown.updates.at(0)->rewound);
        QVERIFY(shown.updates.at(0)->lines.empty());
        QVERIFY(shown.updates.at(0)->task);
        shown.feed.showNow();
        QVERIFY(!shown.updates.at(1)->rewound);
    }
};

USAR_TEST(tst_UpdateFeed)

} // namespace tst_update_feed

#include "tst_update_feed.moc"
