// Nobody leaves a robot in the air by one key.
#include <QTest>

#include "tests/hands/program.h"
#include "tests/suite/suite.h"

namespace tst_hands_leaving {

using namespace usar::hands;

class tst_HandsLeaving : public QObject {
    Q_OBJECT
private slots:
    void quittingInFlightAsksAndWithoutAnAnswerStays();
    void closingTheWindowInFlightAsksToo();

private:
    /// True if R1 flies; the program is started again where a test has ended it.
    bool flies();
    /// Waits until the program asks, or ends without; what it did instead of asking.
    QString insteadOfAsking();

    std::optional<Program> program_;
};

bool tst_HandsLeaving::flies() {
    if (program_ && program_->trouble().isEmpty())
        return program_->row("R1").contains("drives") || program_->fly();
    program_.emplace();
    return program_->spawnByKeys("PlayerStart", "R1") && program_->fly();
}

QString tst_HandsLeaving::insteadOfAsking() {
    bool asks = false;
    std::optional<int> code;
    const bool did = QTest::qWaitFor(
        [&] { return (asks = program_->says("A robot is at work", 0)) || (code = program_->ended(10)); }, 30000);
    return asks ? QString() : did ? "It quit in flight without a question." : "Nothing happened.";
}

void tst_HandsLeaving::quittingInFlightAsksAndWithoutAnAnswerStays() {
    QVERIFY2(flies(), program_ ? qPrintable(program_->trouble()) : "");
    program_->desk().key("ctrl+q");
    QCOMPARE(insteadOfAsking(), QString());
    program_->screenshot("quit_question");
    QTRY_VERIFY_WITH_TIMEOUT(!program_->says("A robot is at work", 0), 90000);
    QCOMPARE(program_->ended(500), std::nullopt);
    QVERIFY2(program_->row("R1").contains("drives"), qPrintable(program_->row("R1")));
}

void tst_HandsLeaving::closingTheWindowInFlightAsksToo() {
    QVERIFY2(flies(), program_ ? qPrintable(program_->trouble()) : "");
    const auto has_focus = [this] {
        return program_->read().find([](const Seen& seen) { return seen.focused(); }).has_value();
    };
    QTRY_VERIFY2_WITH_TIMEOUT(has_focus(), "nobody in the window hears a key", 30000);
    program_->desk().key("alt+F4");
    QCOMPARE(insteadOfAsking(), QString());
    QVERIFY(program_->press("Stop and quit"));
    QCOMPARE(program_->ended(60000), std::optional(0));
}

USAR_TEST(tst_HandsLeaving)

} // namespace tst_hands_leaving

#include "tst_hands_leaving.moc"
