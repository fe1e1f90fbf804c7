// Typing raw commands with a real keyboard, whose keys the list of completions gets first.
#include <QTest>

#include "tests/hands/program.h"
#include "tests/suite/suite.h"

namespace tst_hands_command_box {

using namespace usar::hands;

class tst_HandsCommandBox : public QObject {
    Q_OBJECT
private slots:
    void tabCompletesAndEnterSends();

private:
    /// Text of the command line.
    static QString typed(const Program& program) {
        const auto line = program.read().find("text", "Raw command", 0);
        return line ? program.read().textOf(*line) : QStringLiteral("(no command line)");
    }
};

void tst_HandsCommandBox::tabCompletesAndEnterSends() {
    Program program;
    QVERIFY2(program.trouble().isEmpty(), qPrintable(program.trouble()));
    QVERIFY(program.says("Connected"));
    program.desk().key("F4");
    program.desk().type("DRI");
    QTRY_COMPARE(typed(program), QStringLiteral("DRI"));
    program.screenshot("completions");
    program.desk().key("Tab");
    QTRY_COMPARE(typed(program), QStringLiteral("DRIVE "));
    program.desk().key("ctrl+a");
    program.desk().type("SET {Type Camera}");
    program.desk().key("Return");
    QTRY_COMPARE(typed(program), QString());
    QVERIFY(program.says("SET {Type Camera}")); // in the list of messages
    program.screenshot("sent");
}

USAR_TEST(tst_HandsCommandBox)

} // namespace tst_hands_command_box

#include "tst_hands_command_box.moc"
