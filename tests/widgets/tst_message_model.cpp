#include <limits>

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

#include "core/protocol/reader.h"
#include "tests/suite/suite.h"
#include "widgets/models/messages/message_filter.h"
#include "widgets/models/messages/message_model.h"
#include "widgets/models/messages/message_parts.h"
#include "widgets/style/theme.h"

namespace tst_message_model {

using namespace usar;
using namespace usar::widgets;

namespace {

MessageRow line(std::uint64_t number, const std::string& text, Direction way = Direction::In) {
    return {number, Seconds(1.0), way, typeOf(text), text, {}, {}};
}

std::vector<MessageRow> lines(std::uint64_t first, std::uint64_t count) {
    std::vector<MessageRow> rows;
    for (std::uint64_t i = 0; i < count; ++i)
        rows.push_back(line(first + i, (first + i) % 2 == 0 ? "SEN {Type Sonar}" : "STA {Time 1}"));
    return rows;
}

} // namespace

class tst_MessageModel : public QObject {
    Q_OBJECT
private slots:
    void findsWhateverTheCase_data();
    void findsWhateverTheCase();
    void findsWhatAPlainSearchFinds();
    void typeIsTheFirstWordAndTheType_data();
    void typeIsTheFirstWordAndTheType();
    void badLineCarriesItsReason();
    void commandSaysWhyItWasSent();
    void oldestFallOutAndItSaysHowManyWereShown();
    void batchLargerThanTheRingKeepsItsEnd();
    void textIsBoundedInBytes();
    void modelIsSoundThroughAllChanges();
    void oneInsertionForABatch();
    void filterLooksAtTypeTextAndWay_data();
    void filterLooksAtTypeTextAndWay();
    void filteredRowsKeepTheirOrderWhenTheRingTurns();
    void troubleIsColoredAndHasASign();
    void unknownTimeIsADash();
    void longLinesAreCutForTheEyeOnly();
    void filterLooksAtTypesNameTroubleAndConnection_data();
    void filterLooksAtTypesNameTroubleAndConnection();
    void olderRowsComeInSlicesAboveTheNewest();
    void typesAreCountedWhileTheirLinesAreKept();
    void commandsAndTheirCausesAreFound();
    void familyIsWhatALineIsAbout_data();
    void familyIsWhatALineIsAbout();
    void caretStandsUnderItsByte_data();
    void caretStandsUnderItsByte();
    void partsOfACommandSayWhatTheyMean();
};

void tst_MessageModel::findsWhateverTheCase_data() {
    QTest::addColumn<QByteArray>("needle");
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<bool>("found");
    QTest::newRow("empty needle") << QByteArray("") << QByteArray("abc") << true;
    QTest::newRow("at the start") << QByteArray("SEN") << QByteArray("sen {x}") << true;
    QTest::newRow("at the end") << QByteArray("range") << QByteArray("The RANGE") << true;
    QTest::newRow("needle longer than text") << QByteArray("abcd") << QByteArray("abc") << false;
    QTest::newRow("empty text") << QByteArray("a") << QByteArray("") << false;
    QTest::newRow("repeated letters") << QByteArray("aab") << QByteArray("aaaab") << true;
    QTest::newRow("near miss") << QByteArray("sonat") << QByteArray("sonar sonar") << false;
    QTest::newRow("beyond ASCII") << QByteArray("hügel") << QByteArray("HüGEL") << true;
}

void tst_MessageModel::findsWhateverTheCase() {
    QFETCH(QByteArray, needle);
    QFETCH(QByteArray, text);
    QTEST(CaselessFinder(needle.toStdString()).isIn(text.toStdString()), "found");
}

void tst_MessageModel::findsWhatAPlainSearchFinds() {
    const std::string text = "abacabadabacabaeabacabadabacaba";
    for (std::size_t from = 0; from < text.size(); ++from)
        for (std::size_t length = 1; from + length <= text.size(); ++length) {
            std::string needle = text.substr(from, length);
            QVERIFY(CaselessFinder(needle).isIn(text));
            needle.back() = 'f';
            QVERIFY(!CaselessFinder(needle).isIn(text));
        }
}

void tst_MessageModel::typeIsTheFirstWordAndTheType_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("type");
    QTest::newRow("sensor") << QByteArray("SEN {Time 1} {Type Sonar} {Name F1}") << QByteArray("SEN Sonar");
    QTest::newRow("state") << QByteArray("STA {Time 1}") << QByteArray("STA");
    QTest::newRow("command") << QByteArray("GETGEO {Type Robot}") << QByteArray("GETGEO Robot");
    QTest::newRow("type without an end") << QByteArray("SEN {Type Son") << QByteArray("SEN Son");
    QTest::newRow("empty line") << QByteArray("") << QByteArray("");
    QTest::newRow("endless word") << QByteArray(500, 'x') << QByteArray(48, 'x');
}

void tst_MessageModel::typeIsTheFirstWordAndTheType() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, type);
    QCOMPARE(QByteArray::fromStdString(typeOf(text.toStdString())), type);
}

void tst_MessageModel::badLineCarriesItsReason() {
    protocol::InfoLine bad{{7}, "SEN {Type Sonar", protocol::GenericMessage{}, {}};
    bad.diagnostics = {{Severity::Note, 0, "odd"}, {Severity::Error, 4, "no closing brace"}};
    const MessageRow row = rowOf(bad, Seconds(2.5));
    QCOMPARE(row.number, 7U);
    QVERIFY(row.trouble == Severity::Error);
    QVERIFY(row.note.find("odd") != std::string::npos);
    QVERIFY(row.note.find("no closing brace") != std::string::npos);
    MessageModel model;
    model.append({row});
    const QString tip = model.index(0, MessageModel::Text).data(Qt::ToolTipRole).toString();
    QVERIFY(tip.contains(QStringLiteral("no closing brace")));
}

void tst_MessageModel::commandSaysWhyItWasSent() {
    const MessageRow row = rowOf("GETSTARTPOSES", {by::Behavior{"airrobot/cpp", "scanning"}, {1234}}, 3, Seconds(9));
    QVERIFY(row.direction == Direction::Out);
    QCOMPARE(row.type, std::string("GETSTARTPOSES"));
    QCOMPARE(row.note, std::string("airrobot/cpp: scanning, on line 1234"));
    QCOMPARE(row.number, 3U);
    QCOMPARE(row.trigger, 1234U);
}

void tst_MessageModel::oldestFallOutAndItSaysHowManyWereShown() {
    MessageModel model(nullptr, 10);
    QCOMPARE(model.append(lines(1, 10)), 0);
    QCOMPARE(model.append(lines(11, 4)), 4);
    QCOMPARE(model.rowCount(), 10);
    QCOMPARE(model.row(0).number, 5U);
    model.setFilter({QStringLiteral("sonar"), {}});
    QCOMPARE(model.append(lines(15, 4)), 2);
    QCOMPARE(model.total(), 10);
}

void tst_MessageModel::batchLargerThanTheRingKeepsItsEnd() {
    MessageModel model(nullptr, 10);
    model.append(lines(1, 5));
    model.append(lines(6, 25));
    QCOMPARE(model.rowCount(), 10);
    QCOMPARE(model.row(0).number, 21U);
    QCOMPARE(model.row(9).number, 30U);
}

void tst_MessageModel::textIsBoundedInBytes() {
    MessageModel model(nullptr, 1000, 100'000);
    for (std::uint64_t i = 0; i < 50; ++i)
        model.append({line(i, std::string(9'000, 'x'))});
    QVERIFY(model.rowCount() >= 9 && model.rowCount() <= 11);
    QCOMPARE(model.row(model.rowCount() - 1).number, 49U);
    model.append({line(50, std::string(200'000, 'x'))});
    QVERIFY(model.rowCount() <= 11);
}

void tst_MessageModel::modelIsSoundThroughAllChanges() {
    MessageModel model(nullptr, 20);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    for (std::uint64_t i = 0; i < 60; i += 7)
        model.append(lines(i, 7));
    model.setFilter({QStringLiteral("SONAR"), {}});
    model.append(lines(100, 9));
    model.append({});
    model.setFilter({QString(), Direction::Out});
    QCOMPARE(model.rowCount(), 0);
    model.append(lines(200, 30));
    model.setFilter({});
    QCOMPARE(model.rowCount(), 20);
    model.clear();
    model.append(lines(300, 3));
    QCOMPARE(model.rowCount(), 3);
}

void tst_MessageModel::oneInsertionForABatch() {
    MessageModel model;
    QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
    model.append(lines(1, 500));
    QCOMPARE(inserted.count(), 1);
    model.setFilter({QStringLiteral("no such text"), {}});
    model.append(lines(501, 500));
    QCOMPARE(inserted.count(), 1);
}

void tst_MessageModel::filterLooksAtTypeTextAndWay_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<int>("way"); // 0 both, 1 in, 2 out
    QTest::addColumn<int>("rows");
    QTest::newRow("all") << "" << 0 << 4;
    QTest::newRow("type that is not one piece of the text") << "sen sonar" << 0 << 1;
    QTest::newRow("text, any case") << "f1 RANGE" << 0 << 1;
    QTest::newRow("in") << "" << 1 << 2;
    QTest::newRow("out") << "" << 2 << 2;
    QTest::newRow("words and way") << "drive" << 2 << 1;
    QTest::newRow("words in the other way") << "drive" << 1 << 0;
}

void tst_MessageModel::filterLooksAtTypeTextAndWay() {
    QFETCH(QString, words);
    QFETCH(int, way);
    MessageModel model;
    model.append({line(1, "SEN {Time 1} {Type Sonar} {Name F1 Range 2}"), line(2, "STA {Time 1}"),
                  line(1, "DRIVE {AltitudeVelocity 1}", Direction::Out),
                  line(2, "GETGEO {Type Robot}", Direction::Out)});
    MessageFilter filter{words, {}};
    if (way > 0)
        filter.direction = way == 1 ? Direction::In : Direction::Out;
    model.setFilter(filter);
    QTEST(model.rowCount(), "rows");
}

void tst_MessageModel::filteredRowsKeepTheirOrderWhenTheRingTurns() {
    MessageModel model(nullptr, 50);
    model.setFilter({QStringLiteral("sonar"), {}});
    for (std::uint64_t i = 0; i < 400; i += 13)
        model.append(lines(i, 13));
    for (int i = 1; i < model.rowCount(); ++i)
        QCOMPARE(model.row(i).number, model.row(i - 1).number + 2);
    QVERIFY(model.rowCount() >= 24);
}

void tst_MessageModel::troubleIsColoredAndHasASign() {
    MessageModel model;
    MessageRow bad = line(1, "SEN {Type Sonar");
    bad.trouble = Severity::Error;
    model.append({bad, line(2, "STA {Time 1}")});
    QCOMPARE(model.index(0, MessageModel::Text).data(Qt::ForegroundRole).value<QColor>(), tokens().danger);
    QVERIFY(!model.index(0, MessageModel::Type).data(Qt::DecorationRole).isNull());
    QVERIFY(model.index(1, MessageModel::Type).data(Qt::DecorationRole).isNull());
}

void tst_MessageModel::unknownTimeIsADash() {
    MessageModel model;
    MessageRow early = line(1, "NFO");
    early.time = Seconds(std::numeric_limits<double>::quiet_NaN());
    model.append({early});
    QCOMPARE(model.index(0, MessageModel::Time).data().toString(), QString::fromUtf8("–"));
}

void tst_MessageModel::longLinesAreCutForTheEyeOnly() {
    MessageModel model;
    model.append({line(1, "SEN " + std::string(5'000, '7'))});
    QVERIFY(model.index(0, MessageModel::Text).data().toString().size() < 1'000);
    QCOMPARE(model.row(0).text.size(), 5'004U);
}

void tst_MessageModel::filterLooksAtTypesNameTroubleAndConnection_data() {
    QTest::addColumn<MessageFilter>("filter");
    QTest::addColumn<QList<int>>("numbers");
    const auto row = [](const char* name, const QList<int>& numbers, auto set) {
        MessageFilter filter;
        set(filter);
        QTest::newRow(name) << filter << numbers;
    };
    using Filter = MessageFilter;
    row("one type", {1, 5}, [](Filter& f) { f.types = {{"SEN Sonar"}, true}; });
    row("two types", {1, 3, 5}, [](Filter& f) { f.types = {{"SEN Sonar", "STA"}, true}; });
    row("all but one", {2, 3, 4}, [](Filter& f) { f.types = {{"SEN Sonar"}, false}; });
    row("none", {}, [](Filter& f) { f.types.only_these = true; });
    row("name", {1}, [](Filter& f) { f.name = "f1"; });
    row("later name of a line", {1, 5}, [](Filter& f) { f.name = "F2"; });
    row("what is no name", {}, [](Filter& f) { f.name = "Range"; });
    row("only trouble", {4}, [](Filter& f) { f.only_trouble = true; });
    row("connection", {5}, [](Filter& f) { f.connection = ConnectionId{2}; });
    row("expression", {1}, [](Filter& f) { f.words = "/f[12] range 2\\.5/"; });
    row("expression on the type", {1, 2, 5}, [](Filter& f) { f.words = "/^SEN (Sonar|INS)$/"; });
    row("broken expression", {}, [](Filter& f) { f.words = "/f[12/"; });
    row("slash alone is a word", {}, [](Filter& f) { f.words = "/"; });
    row("reason", {4}, [](Filter& f) { f.words = "no closing"; });
    row("all at once", {1}, [](Filter& f) {
        f.words = "range";
        f.direction = Direction::In;
        f.types = {{"STA"}, false};
        f.name = "F2";
        f.connection = ConnectionId{0};
    });
}

void tst_MessageModel::filterLooksAtTypesNameTroubleAndConnection() {
    QFETCH(MessageFilter, filter);
    QFETCH(QList<int>, numbers);
    MessageRow bad = line(4, "SEN {Type Odd");
    bad.trouble = Severity::Error;
    bad.note = "no closing brace";
    MessageRow other = line(5, "SEN {Type Sonar} {Name F2 Range 3.5}");
    other.connection = ConnectionId{2};
    MessageModel model;
    model.append({line(1, "SEN {Type Sonar} {Name F1 Range 2.5} {Name F2 Range 5.0}"),
                  line(2, "SEN {Type INS} {Name INS}"), line(3, "STA {Time 1}"), bad, other});
    model.setFilter(filter);
    QList<int> shown;
    for (int row = 0; row < model.rowCount(); ++row)
        shown << static_cast<int>(model.row(row).number);
    QCOMPARE(shown, numbers);
}

void tst_MessageModel::olderRowsComeInSlicesAboveTheNewest() {
    MessageModel model;
    model.append(lines(0, 100'000));
    QSignalSpy filtered(&model, &MessageModel::filtered);
    model.setFilter({QStringLiteral("/SONAR.*$/")});
    QVERIFY(model.filtering());
    QVERIFY(model.rowCount() > 0);
    QCOMPARE(model.row(model.rowCount() - 1).number, 99'998U);
    const std::uint64_t serial = model.serial(0);
    model.append(lines(100'000, 1000)); // a thousand of the unseen fall out meanwhile
    QTRY_COMPARE(filtered.count(), 1);
    QCOMPARE(model.rowCount(), 50'000);
    QCOMPARE(model.row(0).number, 1000U);
    QVERIFY(model.shownRow(serial) > 0);
    for (int row = 1; row < model.rowCount(); ++row)
        QVERIFY(model.serial(row) > model.serial(row - 1));
}

void tst_MessageModel::typesAreCountedWhileTheirLinesAreKept() {
    MessageModel model(nullptr, 4);
    model.append({line(1, "NFO {A 1}"), line(2, "STA {B 1}"), line(3, "STA {B 2}")});
    QCOMPARE(model.types().at("STA"), 2);
    QCOMPARE(model.types().size(), 2U);
    model.append({line(4, "STA {B 3}"), line(5, "STA {B 4}")});
    QCOMPARE(model.types().size(), 1U);
    QCOMPARE(model.types().at("STA"), 4);
    model.clear();
    QVERIFY(model.types().empty());
}

void tst_MessageModel::commandsAndTheirCausesAreFound() {
    MessageModel model(nullptr, 100);
    MessageRow drive = rowOf("DRIVE {Left 1}", {by::Other{"test"}, {2}}, 1, Seconds(1));
    MessageRow elsewhere = drive;
    elsewhere.connection = ConnectionId{3};
    model.append({line(1, "STA {Time 1}"), line(2, "STA {Time 2}"), elsewhere, drive});
    QCOMPARE(model.serialOf({0}, Direction::In, 2), std::optional<std::uint64_t>(1));
    QCOMPARE(model.serialOf({3}, Direction::In, 2), std::nullopt);
    QCOMPARE(model.causedBy(1), std::vector<std::uint64_t>{3});
    QVERIFY(model.causedBy(0).empty());
    QVERIFY(model.causedBy(3).empty());
    QVERIFY(!model.find(4));
}

void tst_MessageModel::familyIsWhatALineIsAbout_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<Direction>("way");
    QTest::addColumn<LineFamily>("family");
    QTest::newRow("state") << QByteArray("STA {Time 1}") << Direction::In << LineFamily::State;
    QTest::newRow("range sensor") << QByteArray("SEN {Type RangeScanner}") << Direction::In << LineFamily::Range;
    QTest::newRow("pose sensor") << QByteArray("SEN {Type INS}") << Direction::In << LineFamily::Pose;
    QTest::newRow("other sensor") << QByteArray("SEN {Type RFID}") << Direction::In << LineFamily::Sensor;
    QTest::newRow("answer") << QByteArray("CONF {Type Sonar}") << Direction::In << LineFamily::Answer;
    QTest::newRow("own drive") << QByteArray("DRIVE {Left 1}") << Direction::Out << LineFamily::Drive;
    QTest::newRow("own question") << QByteArray("GETCONF {Type Sonar}") << Direction::Out << LineFamily::Command;
    QTest::newRow("garbage") << QByteArray("HTTP/1.1 400") << Direction::In << LineFamily::Other;
}

void tst_MessageModel::familyIsWhatALineIsAbout() {
    QFETCH(QByteArray, text);
    QFETCH(Direction, way);
    QTEST(familyOf(line(1, text.toStdString(), way)), "family");
}

void tst_MessageModel::caretStandsUnderItsByte_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("offset");
    QTest::addColumn<QString>("excerpt");
    QTest::addColumn<QString>("caret");
    QTest::newRow("short line") << QByteArray("SEN {A") << 4 << "SEN {A"
                                << "    ^";
    QTest::newRow("behind its end") << QByteArray("SEN") << 3 << "SEN"
                                    << "   ^";
    QTest::newRow("middle of a long line") << QByteArray("0123456789abcdefghij") << 10 << "…6789abcd…"
                                           << "     ^";
    QTest::newRow("end of a long line") << QByteArray("0123456789abcdefghij") << 20 << "…bcdefghij"
                                        << "          ^";
    QTest::newRow("bytes nobody can print") << QByteArray("a\x01\xff"
                                                          "b")
                                            << 3 << "a  b"
                                            << "   ^";
}

void tst_MessageModel::caretStandsUnderItsByte() {
    QFETCH(QByteArray, text);
    QFETCH(int, offset);
    const Pointer pointer = pointerAt(text.toStdString(), static_cast<std::size_t>(offset), 10);
    QTEST(pointer.excerpt, "excerpt");
    QTEST(pointer.caret, "caret");
}

void tst_MessageModel::partsOfACommandSayWhatTheyMean() {
    const MessageParts parts = partsOf(line(1, "DRIVE {Left 1.0} {Right x}", Direction::Out));
    QCOMPARE(parts.segments.size(), 2U);
    QCOMPARE(parts.segments[0].value, std::string("1.0"));
    QVERIFY(!parts.segments[0].help.empty());
    QCOMPARE(parts.diagnostics.size(), 1U); // x is no number
    QVERIFY(parts.fields.empty());
}

USAR_TEST(tst_MessageModel)

} // namespace tst_message_model

#include "tst_message_model.moc"
