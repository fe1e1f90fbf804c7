// What a silent server said last is shown as that, in all views, and it stays so when another server comes.
#include <csignal>

#include <QRegularExpression>
#include <QTest>

#include "tests/hands/program.h"
#include "tests/suite/signaling.h"
#include "tests/suite/suite.h"

namespace tst_hands_silence {

using namespace usar::hands;

namespace {

/// usar-sim as a process that can be frozen, as a network can, and killed.
class Simulator {
public:
    explicit Simulator(int port = 0) {
        process_.start(USAR_BINARY_DIR "/bin/usar-sim", {"--port", QString::number(port)});
        const QRegularExpression number("on 127\\.0\\.0\\.1:(\\d+)");
        QByteArray said;
        while (port_ == 0 && process_.waitForReadyRead(60000)) {
            said += process_.readAll();
            if (const auto match = number.match(QString::fromLocal8Bit(said)); match.hasMatch())
                port_ = match.captured(1).toInt();
        }
    }
    ~Simulator() { kill(); }
    Q_DISABLE_COPY_MOVE(Simulator)

    int port() const { return port_; }
    bool freeze() { return usar::test::sendSignal(process_.processId(), SIGSTOP); }
    void kill() {
        process_.kill();
        process_.waitForFinished();
    }

private:
    QProcess process_;
    int port_ = 0; ///< 0: it does not listen
};

} // namespace

class tst_HandsSilence : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void aSilentServerMakesAllViewsSaySo();
    void aScreenReaderHearsIt();
    void aRobotOfAServerThatWasKilledIsGoneAfterItsRestart();
    void whatItSaidStaysOutOfDate();

private:
    /// Waits until every figure and mark says that it is out of date; the one that does not.
    QString fresh() const;

    Simulator simulator_;
    std::optional<Simulator> again_;
    std::optional<Program> program_;
};

constexpr int patience_ms = 30000;
const QString attitude = "Attitude and heading"; ///< the instruments below it are off the screen until one scrolls

QString tst_HandsSilence::fresh() const {
    for (const QString& name : QStringList{"elapsed", "flown", "Battery", attitude, "Robot R1"})
        if (!QTest::qWaitFor([&] { return program_->figure(name).contains("out of date"); }, patience_ms))
            return QStringLiteral("%1 says \"%2\"").arg(name, program_->figure(name));
    const auto is_value = [](const Seen& seen) { return seen.role == "tree item" && !seen.name.isEmpty(); };
    for (const Seen& seen : program_->read().all(is_value))
        if (seen.description != "out of date")
            return "the sensor's " + seen.name;
    return {};
}

void tst_HandsSilence::initTestCase() {
    QVERIFY(simulator_.port() > 0);
    program_.emplace(QSize(1280, 800), QStringList{"--connect", QStringLiteral("127.0.0.1:%1").arg(simulator_.port())});
    QVERIFY2(program_->trouble().isEmpty(), qPrintable(program_->trouble()));
    QVERIFY(program_->spawnByKeys("PlayerStart", "R1"));
    QVERIFY(program_->fly());
}

void tst_HandsSilence::aSilentServerMakesAllViewsSaySo() {
    QVERIFY2(!program_->figure(attitude).contains("out of date"), qPrintable(program_->figure(attitude)));
    QVERIFY2(!program_->row("R1").contains("no news"), qPrintable(program_->row("R1")));
    QVERIFY(!program_->read().find("label", "stale", 0));
    QVERIFY(simulator_.freeze());
    QTRY_VERIFY2_WITH_TIMEOUT(program_->row("R1").contains("no news"), qPrintable(program_->row("R1")), patience_ms);
    QVERIFY(program_->read().find("label", "stale", patience_ms));
    program_->screenshot("silent");
}

void tst_HandsSilence::aScreenReaderHearsIt() {
    QCOMPARE(fresh(), QString());
}

void tst_HandsSilence::aRobotOfAServerThatWasKilledIsGoneAfterItsRestart() {
    simulator_.kill();
    again_.emplace(simulator_.port());
    QCOMPARE(again_->port(), simulator_.port());
    // While there is no link, the row says that instead.
    QTRY_VERIFY2_WITH_TIMEOUT(program_->row("R1").contains("ended early"), qPrintable(program_->row("R1")), 90000);
    QVERIFY2(program_->row("R1").contains("no news"), qPrintable(program_->row("R1")));
    program_->screenshot("after_restart");
}

void tst_HandsSilence::whatItSaidStaysOutOfDate() {
    QCOMPARE(fresh(), QString());
}

USAR_TEST(tst_HandsSilence)

} // namespace tst_hands_silence

#include "tst_hands_silence.moc"
