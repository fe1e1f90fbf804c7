#include <algorithm>

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "tests/suite/suite.h"
#include "widgets/bars/result_card.h"

namespace tst_mission_outcome {

using namespace usar;
using namespace usar::widgets;

namespace {

MissionOutcome wholeFlight() {
    return {.robot = QStringLiteral("R1"),
            .success = true,
            .reason = QStringLiteral("The area is scanned."),
            .coverage_pct = 99.74,
            .duration = Seconds(522.0),
            .distance_m = 411.6,
            .charges = 1,
            .heights_m = std::pair(-2.96, 18.37),
            .error_m = 0.437,
            .files = {QStringLiteral("/scans/S_001.bil"), QStringLiteral("/scans/S_001_height.png"),
                      QStringLiteral("/scans/S_001_picture.png"), QStringLiteral("/scans/S_001_3d.png")}};
}

QStringList textsOf(const MissionOutcome& outcome) {
    QStringList texts;
    for (const OutcomeFigure& figure : figuresOf(outcome))
        texts << figure.name + u' ' + figure.value;
    return texts;
}

QPushButton* button(const ResultCard& card, const QString& text) {
    const auto all = card.findChildren<QPushButton*>();
    const auto found = std::ranges::find(all, text, &QPushButton::text);
    return found == all.end() ? nullptr : *found;
}

bool says(const ResultCard& card, const QString& words) {
    return std::ranges::any_of(card.findChildren<QLabel*>(), [&](const QLabel* label) {
        return !label->isHidden() &&
               QString(label->text()).replace(QStringLiteral("&nbsp;"), QStringLiteral(" ")).contains(words);
    });
}

} // namespace

class tst_MissionOutcome : public QObject {
    Q_OBJECT
private slots:
    void whatCannotBeReachedIsTold() {
        MissionOutcome outcome = wholeFlight();
        QVERIFY(!textsOf(outcome).join(u';').contains("reached"));
        outcome.reachable_pct = 98.25;
        outcome.unreachable = QStringLiteral("12 % of the mission area cannot be reached.");
        QVERIFY(textsOf(outcome).contains(QStringLiteral("Of what can be reached 98.3 %")) ||
                textsOf(outcome).contains(QStringLiteral("Of what can be reached 98.2 %")));
        QCOMPARE(figuresOf(outcome)[1].help, outcome.unreachable);
    }

    void aCorrectedMapTellsHowFarItsPathWasMoved() {
        MissionOutcome outcome = wholeFlight();
        QVERIFY(!textsOf(outcome).join(u';').contains("moved"));
        outcome.shift_m = std::pair(0.412, 1.066);
        QVERIFY(textsOf(outcome).contains(QStringLiteral("Path moved 0.41 m, 1.07 m at most")));
    }

    void whatABehaviorToldIsTakenOver() {
        agent::BehaviorStatus status;
        status.elapsed = Seconds(12.0);
        status.distance_flown_m = 3.4;
        status.charges = 2;
        const MissionOutcome ended =
            outcomeOf(QStringLiteral("R1"), 40.0, agent::BehaviorFinished{true, "Done."}, status);
        QVERIFY(ended.success);
        QCOMPARE(ended.reason, QStringLiteral("Done."));
        QCOMPARE(textsOf(ended), (QStringList{QStringLiteral("Coverage 40.0 %"), QStringLiteral("Time 12 s"),
                                              QStringLiteral("Distance 3 m"), QStringLiteral("Charges 2")}));
        QVERIFY(ended.files.isEmpty());
    }

    void aBehaviorThatToldNothingHasNoSuccess() {
        const MissionOutcome ended = outcomeOf(QStringLiteral("R1"), {}, {}, {});
        QVERIFY(!ended.success);
        QVERIFY(!ended.coverage_pct);
        QCOMPARE(ended.robot, QStringLiteral("R1"));
    }

    void allThatIsKnownIsTold() {
        QCOMPARE(textsOf(wholeFlight()),
                 (QStringList{QStringLiteral("Coverage 99.7 %"), QStringLiteral("Time 8 min 42 s"),
                              QStringLiteral("Distance 412 m"), QStringLiteral("Heights −3.0 to 18.4 m"),
                              QStringLiteral("Error 0.44 m"), QStringLiteral("Charges 1")}));
        QCOMPARE(titleOf(wholeFlight()), QStringLiteral("R1: mission complete"));
        QCOMPARE(pictureOf(wholeFlight()), QStringLiteral("/scans/S_001_picture.png"));
        QCOMPARE(reliefPictureOf(wholeFlight()), QStringLiteral("/scans/S_001_3d.png"));
        QCOMPARE(folderOf(wholeFlight()), QStringLiteral("/scans"));
    }

    void whatIsNotKnownIsLeftOut() {
        const MissionOutcome drive{.robot = QStringLiteral("R2"), .duration = Seconds(12.0), .distance_m = 3.0};
        QCOMPARE(textsOf(drive), (QStringList{QStringLiteral("Time 12 s"), QStringLiteral("Distance 3 m")}));
        QCOMPARE(titleOf(drive), QStringLiteral("R2: mission ended early"));
        QVERIFY(pictureOf(drive).isEmpty() && reliefPictureOf(drive).isEmpty() && folderOf(drive).isEmpty());
    }

    void theCardIsSeenOnceThereIsSomethingToTell() {
        ResultCard card;
        QVERIFY(card.isHidden());
        card.tell(wholeFlight());
        QVERIFY(card.isVisible());
        for (const char* words : {"R1: mission complete", "The area is scanned.", "Heights <b>−3.0 to 18.4 m</b>"})
            QVERIFY2(says(card, QString::fromUtf8(words)), words);
        QTest::mouseClick(card.findChild<QToolButton*>(), Qt::LeftButton);
        QVERIFY(card.isHidden());
    }

    void itsButtonsTellWhatIsWanted() {
        ResultCard card;
        QSignalSpy folder(&card, &ResultCard::folderRequested);
        QSignalSpy picture(&card, &ResultCard::pictureRequested);
        QSignalSpy again(&card, &ResultCard::flyAgainRequested);
        card.tell(wholeFlight());
        QTest::mouseClick(button(card, QStringLiteral("Open folder")), Qt::LeftButton);
        QTest::mouseClick(button(card, QStringLiteral("Open picture")), Qt::LeftButton);
        QTest::mouseClick(button(card, QStringLiteral("Fly again")), Qt::LeftButton);
        QCOMPARE(folder.value(0).value(0).toString(), QStringLiteral("/scans"));
        QCOMPARE(picture.value(0).value(0).toString(), QStringLiteral("/scans/S_001_picture.png"));
        QCOMPARE(again.size(), 1);
    }

    void whatCannotBeOpenedHasNoButton() {
        ResultCard card;
        card.tell({.robot = QStringLiteral("R2")});
        QVERIFY(button(card, QStringLiteral("Open folder"))->isHidden());
        QVERIFY(button(card, QStringLiteral("Open picture"))->isHidden());
        card.setCanFlyAgain(false);
        QVERIFY(button(card, QStringLiteral("Fly again"))->isHidden());
    }

    void thePicturesNeedRoom() {
        QWidget window; // A card that is a window itself would not become that narrow.
        ResultCard card(&window);
        window.show();
        card.tell(wholeFlight());
        QImage picture(ResultCard::picture_px, QImage::Format_RGB32);
        picture.fill(Qt::gray);
        const auto shown = [&] {
            return std::ranges::count_if(card.findChildren<QLabel*>(), [](const QLabel* label) {
                return !label->isHidden() && !label->pixmap(Qt::ReturnByValue).isNull();
            });
        };
        card.resize(700, 150);
        card.setPictures(picture, {});
        QCOMPARE(shown(), 1);
        card.setPictures(picture, picture);
        QCOMPARE(shown(), 2);
        card.resize(card.minimumSizeHint().width() + ResultCard::picture_px.width() + 40, 150);
        QCOMPARE(shown(), 1);
        card.resize(card.minimumSizeHint());
        QCOMPARE(shown(), 0);
        card.resize(700, 150);
        QCOMPARE(shown(), 2);
        card.tell(wholeFlight()); // Those of another mission are not there yet.
        QCOMPARE(shown(), 0);
    }
};

USAR_TEST(tst_MissionOutcome)

} // namespace tst_mission_outcome

#include "tst_mission_outcome.moc"
