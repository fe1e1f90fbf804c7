#include <QLabel>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include "tests/suite/suite.h"
#include "widgets/bars/strips.h"

namespace tst_first_steps {

using namespace usar::widgets;

class tst_FirstSteps : public QObject {
    Q_OBJECT
private slots:
    void init() {
        strip_ = std::make_unique<HintStrip>();
        strip_->setWhatNext(QStringLiteral("P pauses the robot."));
        strip_->show();
    }

    void theNextStepIsTheFirstThatIsNotDone() {
        FirstSteps steps;
        QCOMPARE(steps.next(), std::optional(FirstStep::Spawn));
        steps.setDone(FirstStep::Area);
        QCOMPARE(steps.next(), std::optional(FirstStep::Spawn));
        steps.setDone(FirstStep::Spawn);
        QCOMPARE(steps.next(), std::optional(FirstStep::Start));
        QVERIFY(!steps.complete());
        steps.setDone(FirstStep::Start);
        QVERIFY(steps.complete() && !steps.next());
    }

    void nobodyIsAskedForAnAreaThatIsNotNeeded() {
        FirstSteps steps;
        steps.setAreaNeeded(false);
        QCOMPARE(steps.steps(), (std::vector{FirstStep::Spawn, FirstStep::Start}));
        steps.setDone(FirstStep::Spawn);
        QCOMPARE(steps.next(), std::optional(FirstStep::Start));
        steps.setAreaNeeded(true);
        QCOMPARE(steps.next(), std::optional(FirstStep::Area));
    }

    void theStripNamesTheNextStep() {
        QVERIFY(strip_->accessibleDescription().contains(HintStrip::textOf(FirstStep::Spawn)));
        strip_->setDone(FirstStep::Spawn);
        QVERIFY(strip_->accessibleDescription().contains(HintStrip::textOf(FirstStep::Area)));
        QVERIFY(text().contains(QStringLiteral("✓")));
        strip_->setAreaNeeded(false);
        QVERIFY(strip_->accessibleDescription().contains(HintStrip::textOf(FirstStep::Start)));
        QVERIFY(!text().contains(QStringLiteral("<b>3</b>")));
    }

    void afterTheLastStepItSaysWhatComesNextAndGoes() {
        for (const FirstStep step : {FirstStep::Spawn, FirstStep::Area, FirstStep::Start})
            strip_->setDone(step);
        QCOMPARE(text(), QStringLiteral("P pauses the robot."));
        QCOMPARE(strip_->accessibleDescription(), QStringLiteral("P pauses the robot."));
        QVERIFY(strip_->isVisible());
        QVERIFY(strip_->dismissed()); // at the next start
        auto* const read = strip_->findChild<QTimer*>();
        QVERIFY(read->isActive());
        read->start(0);
        QTRY_VERIFY(strip_->isHidden());
        strip_->setDone(FirstStep::Start); // the next mission
        QVERIFY(strip_->isHidden() && !read->isActive());
    }

    void itIsDismissedAndShownAgain() {
        QTest::mouseClick(strip_->findChild<QToolButton*>(), Qt::LeftButton);
        QVERIFY(strip_->isHidden() && strip_->dismissed());
        strip_->setDismissed(false);
        QVERIFY(strip_->isVisible());
    }

    void aReplayHidesItForAWhile() {
        strip_->setInReplay(true);
        QVERIFY(strip_->isHidden() && !strip_->dismissed());
        strip_->setInReplay(false);
        QVERIFY(strip_->isVisible());
        strip_->setDismissed(true);
        strip_->setInReplay(true);
        strip_->setInReplay(false);
        QVERIFY(strip_->isHidden());
    }

private:
    QString text() const { return strip_->findChild<QLabel*>()->text(); }

    std::unique_ptr<HintStrip> strip_;
};

USAR_TEST(tst_FirstSteps)

} // namespace tst_first_steps

#include "tst_first_steps.moc"
