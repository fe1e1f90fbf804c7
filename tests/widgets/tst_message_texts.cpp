// Lines of traffic as rows, as saved text and as JSON; filters, the history of sent lines, and saving.
#include <cmath>
#include <limits>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/messages/command_box.h"
#include "widgets/models/messages/message_parts.h"
#include "widgets/models/messages/message_saver.h"

namespace tst_message_texts {

using namespace usar;
using namespace usar::widgets;

namespace {

const Seconds unknown_time{std::numeric_limits<double>::quiet_NaN()};

MessageRow infoRow(std::uint64_t number, const std::string& text, ConnectionId connection = {}) {
    return {.number = number, .time = Seconds(12.25), .type = typeOf(text), .text = text, .connection = connection};
}

MessageRow commandRow(std::uint64_t trigger, ConnectionId connection = {}) {
    MessageRow row =
        rowOf("DRIVE {Left 1.0} {Right 1.0}", {by::readSource("airrobot/posh"), {trigger}}, 3, Seconds(13.0));
    row.connection = connection;
    return row;
}

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class tst_MessageTexts : public QObject {
    Q_OBJECT
private slots:
    void gapsCountInGroups_data();
    void gapsCountInGroups();
    void commandsSayWhoSentThem_data();
    void commandsSayWhoSentThem();
    void savedLinesHaveTabs_data();
    void savedLinesHaveTabs();
    void jsonLeavesOutWhatIsUnknown();
    void jsonOfAGapIsItsCount();
    void fieldsHaveUnits_data();
    void fieldsHaveUnits();
    void slashesMakeAnExpression_data();
    void slashesMakeAnExpression();
    void wordsAreSearchedWhereTheyMayBe_data();
    void wordsAreSearchedWhereTheyMayBe();
    void gapsPassEveryFilterButTheConnections();
    void choiceOfTypesListsOrHides_data();
    void choiceOfTypesListsOrHides();
    void historyWalksOverWhatFits();
    void historyWithoutAWalkHasNothingNewer();
    void modelKnowsConnectionsAndSerials();
    void causesStayOnTheirConnection();
    void savesColumnsOrJson_data();
    void savesColumnsOrJson();
    void savingWhereNothingCanBeWrittenSaysWhatToDo();
    void oneFileAtATime();
};

void tst_MessageTexts::gapsCountInGroups_data() {
    QTest::addColumn<qulonglong>("count");
    QTest::addColumn<QString>("text");
    QTest::newRow("one") << 1ULL << "1 line not shown";
    QTest::newRow("two") << 2ULL << "2 lines not shown";
    QTest::newRow("no group yet") << 999ULL << "999 lines not shown";
    QTest::newRow("one group") << 1000ULL << "1,000 lines not shown";
    QTest::newRow("two groups") << 1234567ULL << "1,234,567 lines not shown";
    QTest::newRow("full groups") << 100200300ULL << "100,200,300 lines not shown";
}

void tst_MessageTexts::gapsCountInGroups() {
    QFETCH(qulonglong, count);
    const MessageRow gap = gapOf(count);
    QTEST(QString::fromStdString(gap.text), "text");
    QCOMPARE(gap.not_shown, std::uint64_t(count));
    QVERIFY(gap.trouble == Severity::Note);
    QVERIFY(std::isnan(gap.time.count()));
}

void tst_MessageTexts::commandsSayWhoSentThem_data() {
    QTest::addColumn<qulonglong>("trigger");
    QTest::addColumn<QString>("note");
    QTest::newRow("by itself") << 0ULL << "airrobot/posh";
    QTest::newRow("on a line") << 41ULL << "airrobot/posh, on line 41";
}

void tst_MessageTexts::commandsSayWhoSentThem() {
    QFETCH(qulonglong, trigger);
    const MessageRow row = commandRow(trigger);
    QTEST(QString::fromStdString(row.note), "note");
    QCOMPARE(row.trigger, std::uint64_t(trigger));
    QVERIFY(row.direction == Direction::Out);
    QCOMPARE(QString::fromStdString(row.type), QStringLiteral("DRIVE"));
    QVERIFY(!row.trouble);
}

void tst_MessageTexts::savedLinesHaveTabs_data() {
    QTest::addColumn<bool>("in");
    QTest::addColumn<bool>("timed");
    QTest::addColumn<QString>("robot");
    QTest::addColumn<QString>("text");
    QTest::newRow("info") << true << true << "R1"
                          << "7\t12.25\tR1\tin\tSTA\tSTA {Time 12.25}";
    QTest::newRow("no name") << true << true << ""
                             << "7\t12.25\t\tin\tSTA\tSTA {Time 12.25}";
    QTest::newRow("no time") << true << false << "R1"
                             << "7\t\tR1\tin\tSTA\tSTA {Time 12.25}";
    QTest::newRow("command") << false << true << "R1"
                             << "7\t12.25\tR1\tout\tSTA\tSTA {Time 12.25}";
}

void tst_MessageTexts::savedLinesHaveTabs() {
    QFETCH(bool, in);
    QFETCH(bool, timed);
    QFETCH(QString, robot);
    MessageRow row = infoRow(7, "STA {Time 12.25}");
    row.direction = in ? Direction::In : Direction::Out;
    if (!timed)
        row.time = unknown_time;
    QTEST(tabbedText(row, robot), "text");
    QCOMPARE(tabbedText(gapOf(5), robot), QStringLiteral("5 lines not shown"));
}

void tst_MessageTexts::jsonLeavesOutWhatIsUnknown() {
    const QJsonObject info = jsonOf(infoRow(7, "STA {Time 12.25} {Battery 1199}"), "R1");
    QCOMPARE(info["direction"].toString(), QStringLiteral("in"));
    QCOMPARE(info["number"].toInteger(), qint64(7));
    QCOMPARE(info["type"].toString(), QStringLiteral("STA"));
    QCOMPARE(info["time_s"].toDouble(), 12.25);
    QCOMPARE(info["robot"].toString(), QStringLiteral("R1"));
    QVERIFY(!info["fields"].toArray().isEmpty());
    QVERIFY(!info.contains("cause"));
    QVERIFY(!info.contains("trigger"));
    MessageRow command = commandRow(41);
    command.time = unknown_time;
    const QJsonObject sent = jsonOf(command, {});
    QCOMPARE(sent["direction"].toString(), QStringLiteral("out"));
    QCOMPARE(sent["cause"].toString(), QStringLiteral("airrobot/posh, on line 41"));
    QCOMPARE(sent["trigger"].toInteger(), qint64(41));
    QVERIFY(sent["fields"].toArray().isEmpty());
    QVERIFY(!sent.contains("time_s"));
    QVERIFY(!sent.contains("robot"));
    QVERIFY(!jsonOf(commandRow(0), {}).contains("trigger"));
}

void tst_MessageTexts::jsonOfAGapIsItsCount() {
    const QJsonObject gap = jsonOf(gapOf(1234), "R1");
    QCOMPARE(gap.keys(), QStringList{"lines_not_shown"});
    QCOMPARE(gap["lines_not_shown"].toInteger(), qint64(1234));
    QVERIFY(partsOf(gapOf(1234)).segments.empty());
}

void tst_MessageTexts::fieldsHaveUnits_data() {
    QTest::addColumn<double>("number");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QString>("text");
    QTest::newRow("length") << 1.5 << "m"
                            << "1.5 m";
    QTest::newRow("none") << 1.5 << ""
                          << "1.5";
    QTest::newRow("whole") << -2.0 << "s"
                           << "-2 s";
    QTest::newRow("angle, also in degrees") << pi / 6.0 << "rad"
                                            << "0.523599 rad (30.0°)";
    QTest::newRow("backward angle") << -pi / 2.0 << "rad"
                                    << "-1.5708 rad (−90.0°)";
    QTest::newRow("small") << 1e-7 << "m"
                           << "1e-07 m";
}

void tst_MessageTexts::fieldsHaveUnits() {
    QFETCH(double, number);
    QFETCH(QString, unit);
    protocol::Field field{.number = number, .text = "as on the wire", .unit = unit.toStdString()};
    QTEST(valueText(field), "text");
    field.number.reset();
    QCOMPARE(valueText(field), QStringLiteral("as on the wire"));
}

void tst_MessageTexts::slashesMakeAnExpression_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<bool>("is_one");
    QTest::addColumn<bool>("valid");
    QTest::newRow("plain") << "sonar" << false << false;
    QTest::newRow("empty") << "" << false << false;
    QTest::newRow("one slash") << "/" << false << false;
    QTest::newRow("nothing between") << "//" << false << false;
    QTest::newRow("open") << "/sonar" << false << false;
    QTest::newRow("not closed at the end") << "/sonar/ f1" << false << false;
    QTest::newRow("expression") << "/son.r/" << true << true;
    QTest::newRow("one letter") << "/s/" << true << true;
    QTest::newRow("slash within") << "/a/b/" << true << true;
    QTest::newRow("invalid") << "/[/" << true << false;
}

void tst_MessageTexts::slashesMakeAnExpression() {
    QFETCH(QString, words);
    QFETCH(bool, is_one);
    QFETCH(bool, valid);
    const auto expression = expressionOf(words);
    QCOMPARE(expression.has_value(), is_one);
    if (is_one)
        QCOMPARE(expression->isValid(), valid);
}

void tst_MessageTexts::wordsAreSearchedWhereTheyMayBe_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<bool>("passes");
    QTest::newRow("text") << "LEFT 1" << true;
    QTest::newRow("type") << "drive" << true;
    QTest::newRow("note") << "POSH" << true;
    QTest::newRow("nowhere") << "sonar" << false;
    QTest::newRow("expression in the text") << "/left \\d/" << true;
    QTest::newRow("expression in the type") << "/^drive$/" << true;
    QTest::newRow("no expression in the note") << "/posh/" << false;
    QTest::newRow("invalid expression") << "/(/" << false;
}

void tst_MessageTexts::wordsAreSearchedWhereTheyMayBe() {
    QFETCH(QString, words);
    QTEST(MessageSieve({.words = words}).passes(commandRow(0)), "passes");
}

void tst_MessageTexts::gapsPassEveryFilterButTheConnections() {
    MessageRow gap = gapOf(3);
    gap.connection = {2};
    QVERIFY(MessageSieve({.words = "sonar"}).passes(gap));
    QVERIFY(MessageSieve({.direction = Direction::Out, .name = "F1", .only_trouble = true}).passes(gap));
    QVERIFY(MessageSieve({.types = {.types = {}, .only_these = true}}).passes(gap));
    QVERIFY(MessageSieve({.connection = ConnectionId{2}}).passes(gap));
    QVERIFY(!MessageSieve({.connection = ConnectionId{1}}).passes(gap));
}

void tst_MessageTexts::choiceOfTypesListsOrHides_data() {
    QTest::addColumn<bool>("listed");
    QTest::addColumn<bool>("only_these");
    QTest::addColumn<bool>("shows");
    QTest::newRow("all") << false << false << true;
    QTest::newRow("hidden") << true << false << false;
    QTest::newRow("listed") << true << true << true;
    QTest::newRow("none") << false << true << false;
}

void tst_MessageTexts::choiceOfTypesListsOrHides() {
    QFETCH(bool, listed);
    QFETCH(bool, only_these);
    TypeChoice choice{.types = {}, .only_these = only_these};
    if (listed)
        choice.types.insert("STA");
    QTEST(choice.shows("STA"), "shows");
}

void tst_MessageTexts::historyWalksOverWhatFits() {
    LineHistory history;
    history.setLines({"DRIVE 1", "GETSTARTPOSES", "drive 2"});
    QCOMPARE(history.older("dri").value_or("-"), QStringLiteral("drive 2"));
    QCOMPARE(history.older("ignored while walking").value_or("-"), QStringLiteral("DRIVE 1"));
    QVERIFY(!history.older("dri"));
    QCOMPARE(history.newer().value_or("-"), QStringLiteral("drive 2"));
    QCOMPARE(history.newer().value_or("-"), QStringLiteral("dri"));
    QVERIFY(!history.newer());
    QCOMPARE(history.older("start").value_or("-"), QStringLiteral("GETSTARTPOSES"));
    history.endWalk();
    QCOMPARE(history.older({}).value_or("-"), QStringLiteral("drive 2"));
}

void tst_MessageTexts::historyWithoutAWalkHasNothingNewer() {
    LineHistory history;
    QVERIFY(!history.newer());
    QVERIFY(!history.older({}));
    history.add("A");
    history.add("B");
    history.add("A");
    QCOMPARE(history.lines(), QStringList({"B", "A"}));
    QVERIFY(!history.newer());
    QCOMPARE(history.older({}).value_or("-"), QStringLiteral("A"));
}

void tst_MessageTexts::modelKnowsConnectionsAndSerials() {
    MessageModel model(nullptr, 3);
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    model.nameConnection({1}, "R1");
    QCOMPARE(changed.count(), 0); // There is no row to change.
    model.append({infoRow(1, "STA {Time 1}", {1}), infoRow(2, "STA {Time 2}", {2}), infoRow(3, "STA {Time 3}", {1}),
                  infoRow(4, "STA {Time 4}", {1})});
    QCOMPARE(model.total(), 3);
    QCOMPARE(model.totalOf({1}), 2);
    QCOMPARE(model.totalOf({2}), 1);
    QCOMPARE(model.totalOf({9}), 0);
    QCOMPARE(model.connectionName({1}), QStringLiteral("R1"));
    QVERIFY(model.connectionName({2}).isEmpty());
    model.nameConnection({2}, "R2");
    model.nameConnection({2}, "R2");
    QCOMPARE(changed.count(), 1);
    for (int row = 0; row < model.rowCount(); ++row) {
        QCOMPARE(model.shownRow(model.serial(row)), row);
        QCOMPARE(model.find(model.serial(row)), &model.row(row));
    }
    QCOMPARE(model.shownRow(1'000'000), -1);
    QVERIFY(!model.find(1'000'000));
    QVERIFY(!model.serialOf({1}, Direction::In, 1)); // It has fallen out of the ring.
    QVERIFY(model.serialOf({1}, Direction::In, 4));
    QVERIFY(!model.serialOf({2}, Direction::In, 4));
    QVERIFY(!model.serialOf({1}, Direction::Out, 4));
}

void tst_MessageTexts::causesStayOnTheirConnection() {
    MessageModel model;
    std::vector<MessageRow> rows{infoRow(41, "STA {Time 1}", {1}), commandRow(41, {2}), commandRow(40, {1})};
    for (int i = 0; i < 7; ++i)
        rows.push_back(commandRow(41, {1}));
    model.append(rows);
    const std::vector<std::uint64_t> caused = model.causedBy(model.serial(0));
    QCOMPARE(caused.size(), 5u); // At most five are named.
    QCOMPARE(caused.front(), model.serial(3));
    QVERIFY(model.causedBy(model.serial(3)).empty()); // A command causes no command.
    QVERIFY(model.causedBy(1'000'000).empty());
}

void tst_MessageTexts::savesColumnsOrJson_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("json");
    QTest::newRow("columns") << "lines.txt" << false;
    QTest::newRow("no suffix") << "lines" << false;
    QTest::newRow("JSON lines") << "lines.jsonl" << true;
    QTest::newRow("JSON lines, whatever the case") << "lines.JSONL" << true;
}

void tst_MessageTexts::savesColumnsOrJson() {
    QFETCH(QString, name);
    QFETCH(bool, json);
    const QTemporaryDir folder;
    MessageModel model;
    model.nameConnection({1}, "R1");
    model.append({infoRow(7, "STA {Time 12.25}", {1}), gapOf(2), commandRow(7, {1})});
    MessageSaver saver(model);
    QSignalSpy saved(&saver, &MessageSaver::saved);
    saver.save(folder.filePath(name));
    QVERIFY(saver.busy());
    QVERIFY(saved.wait());
    QVERIFY(!saver.busy());
    QCOMPARE(saved.front()[1].toInt(), 3);
    const QList<QByteArray> lines = contentOf(folder.filePath(name)).split('\n');
    QCOMPARE(lines.size(), 4); // The last one is empty.
    QVERIFY(lines.back().isEmpty());
    if (!json)
        QCOMPARE(lines[0], QByteArray("7\t12.25\tR1\tin\tSTA\tSTA {Time 12.25}"));
    for (int i = 0; json && i < 3; ++i)
        QVERIFY2(QJsonDocument::fromJson(lines[i]).isObject(), lines[i].constData());
}

void tst_MessageTexts::savingWhereNothingCanBeWrittenSaysWhatToDo() {
    const QTemporaryDir folder;
    MessageModel model;
    MessageSaver saver(model);
    QSignalSpy failed(&saver, &MessageSaver::failed);
    const QString path = folder.filePath("missing/lines.txt");
    saver.save(path);
    QCOMPARE(failed.count(), 1);
    const QString reason = failed.front()[0].toString();
    QVERIFY2(reason.contains(path), qPrintable(reason));
    QVERIFY2(reason.contains("Choose another folder"), qPrintable(reason));
    QVERIFY(!saver.busy());
}

void tst_MessageTexts::oneFileAtATime() {
    const QTemporaryDir folder;
    MessageModel model;
    model.append({infoRow(7, "STA {Time 12.25}")});
    MessageSaver saver(model);
    QSignalSpy saved(&saver, &MessageSaver::saved);
    QSignalSpy failed(&saver, &MessageSaver::failed);
    saver.save(folder.filePath("first.txt"));
    saver.save(folder.filePath("second.txt"));
    QCOMPARE(failed.count(), 1);
    QVERIFY(failed.front()[0].toString().contains("first.txt"));
    QVERIFY(saved.wait());
    QVERIFY(QFile::exists(folder.filePath("first.txt")));
    QVERIFY(!QFile::exists(folder.filePath("second.txt")));
}

USAR_TEST(tst_MessageTexts)

} // namespace tst_message_texts

#include "tst_message_texts.moc"
