#include <QTest>

#include "core/base/cause.h"
#include "tests/suite/suite.h"

namespace tst_cause {

using namespace usar;

class tst_Cause : public QObject {
    Q_OBJECT
private slots:
    void eachKindHasItsText_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<by::Source>("source");
        const auto row = [](const char* text, const by::Source& source) { QTest::newRow(text) << text << source; };
        row("airrobot/cpp: scanning: lane 4", by::Behavior{"airrobot/cpp", "scanning: lane 4"});
        row("p2dx/posh: plan halted", by::Behavior{"p2dx/posh", "plan halted"});
        row("p2dx/posh: rover ▸ drive", by::Plan{"p2dx/posh", "rover ▸ drive", {}});
        row("p2dx/posh: rover ▸ drive: to the left", by::Plan{"p2dx/posh", "rover ▸ drive", "to the left"});
        row("by hand: gamepad Pad 3", by::Hand{"gamepad Pad 3"});
        row("session: spawn", by::Session{"spawn"});
        row("operator: stop", by::Operator{"stop"});
        row("camera", by::Other{"camera"});
        row("", by::Other{});
    }
    void eachKindHasItsText() {
        QFETCH(QString, text);
        QFETCH(by::Source, source);
        QCOMPARE(QString::fromStdString(toText(source)), text);
        QVERIFY(by::readSource(text.toStdString()) == source);
    }

    void anyTextComesBackUnchanged() {
        for (const std::string text : {"test: ", ": test", ": ", "session:", "by hand: ", "operator: ", "a: b ▸ c: ",
                                       "a ▸ b: c", "a: b ▸ c: d: e", "a: : b ▸ c", " ▸ : b", "a: ▸ b"})
            QCOMPARE(toText(by::readSource(text)), text);
    }

    void aDecisionWithoutItsBehaviorIsTheStateAlone() {
        QCOMPARE(toText(by::Behavior{{}, "taking off"}), std::string("taking off"));
        QCOMPARE(toText(by::Plan{{}, "rover ▸ drive", "slowly"}), std::string("rover ▸ drive: slowly"));
    }
};

USAR_TEST(tst_Cause)

} // namespace tst_cause

#include "tst_cause.moc"
