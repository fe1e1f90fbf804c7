#include <QTest>

#include "core/link/tcp_link.h"
#include "tests/suite/suite.h"

namespace tst_greeting_check {

using namespace usar::link;
using Verdict = GreetingCheck::Verdict;

class tst_GreetingCheck : public QObject {
    Q_OBJECT
private slots:
    void judgesByTheFirstLines_data();
    void judgesByTheFirstLines();
    void controlBytesAreForeign();
    void aJudgedServerMaySayAnything();
    void isSuspiciousBeforeItIsSure();
};

void tst_GreetingCheck::judgesByTheFirstLines_data() {
    QTest::addColumn<QByteArrayList>("lines");
    QTest::addColumn<int>("verdict");
    const auto row = [](const char* name, const QByteArrayList& lines, Verdict verdict) {
        QTest::newRow(name) << lines << static_cast<int>(verdict);
    };
    row("UT2004's greeting", {"NFO {Gametype BotDeathMatch} {Level DM-USAR_250}"}, Verdict::Usarsim);
    row("no space before the brace", {"NFO{StartPoses 0}"}, Verdict::Usarsim);
    row("two spaces", {"GEO  {Name P3AT}"}, Verdict::Usarsim);
    row("a word alone settles nothing", {"STA"}, Verdict::Unknown);
    row("one garbled line settles nothing", {"1.2,3.4} {Range 2}"}, Verdict::Unknown);
    row("a garbled line, then a good one", {"1.2,3.4} {Range 2}", "STA {Time 1.00}"}, Verdict::Usarsim);
    row("three strange lines", {"hello there", "who are you", "go away"}, Verdict::Foreign);
    row("HTTP", {"HTTP/1.1 400 Bad Request"}, Verdict::Foreign);
    row("a web page", {"<html><body>No</body></html>"}, Verdict::Foreign);
    row("SSH", {"SSH-2.0-OpenSSH_9.2p1 Debian-2"}, Verdict::Foreign);
    row("SMTP", {"220 mail.example.org ESMTP"}, Verdict::Foreign);
    row("VNC", {"RFB 003.008"}, Verdict::Foreign);
    row("an absurdly long word", {QByteArray(40, 'A') + " {Type x}", "", ""}, Verdict::Foreign);
}

void tst_GreetingCheck::judgesByTheFirstLines() {
    QFETCH(QByteArrayList, lines);
    QFETCH(int, verdict);
    GreetingCheck check;
    for (const QByteArray& line : lines)
        check.takeLine(line.toStdString());
    QCOMPARE(static_cast<int>(check.verdict()), verdict);
}

void tst_GreetingCheck::controlBytesAreForeign() {
    GreetingCheck check;
    check.takeBytes("NFO {Level x}\r\n\tSTA");
    QVERIFY(check.verdict() == Verdict::Unknown);
    check.takeBytes(std::string_view("\x15\x03\x01\x00\x02", 5)); // a TLS alert
    QVERIFY(check.verdict() == Verdict::Foreign);
}

void tst_GreetingCheck::aJudgedServerMaySayAnything() {
    GreetingCheck check;
    check.takeLine("NFO {Level x}");
    check.takeBytes(std::string_view("\0\1\2", 3));
    for (int i = 0; i < 10; ++i)
        check.takeLine("HTTP/1.1 200 OK");
    QVERIFY(check.verdict() == Verdict::Usarsim);
    check.reset();
    check.takeLine("HTTP/1.1 200 OK");
    QVERIFY(check.verdict() == Verdict::Foreign);
}

void tst_GreetingCheck::isSuspiciousBeforeItIsSure() {
    GreetingCheck check;
    QVERIFY(!check.suspicious());
    check.takeLine("who are you");
    QVERIFY(check.suspicious());
    QVERIFY(check.verdict() == Verdict::Unknown);
    check.takeLine("NFO {Level x}");
    QVERIFY(!check.suspicious());
}

USAR_TEST(tst_GreetingCheck)

} // namespace tst_greeting_check

#include "tst_greeting_check.moc"
