#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QLineEdit>
#include <QListView>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include "tests/suite/suite.h"
#include "widgets/messages/notification_center.h"
#include "widgets/messages/toast_stack.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/theme.h"

namespace tst_notifications {

using namespace usar;
using namespace usar::widgets;

namespace {

const QDateTime noon(QDate(2024, 5, 1), QTime(12, 0));
const QString link_key = QStringLiteral("link");
const QString no_answer = QStringLiteral("No answer from 10.0.0.5:3000 after 5 s. Is USARSim running there?");

} // namespace

class tst_Notifications : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void newestIsFirst();
    void theSameTroubleIsCounted();
    void notesAreNotOpenProblems();
    void theProblemsOfARobotAreCuredTogether();
    void curedIsMarkedAndOpensAgainFromOne();
    void modelIsSoundThroughAllChanges();
    void onlyTheNewestAreKept();
    void clearCuredKeepsWhatIsOpen();
    void unreadIsToldOnceForEachChange();
    void sentenceCarriesSeverityCountAndCure_data();
    void sentenceCarriesSeverityCountAndCure();
    void severitiesDifferInWordIconAndColor();
    void seenIsRead();
    void activatingNamesTheKey();
    void copyTakesTheSentence();
    void emptyCenterSaysWhatComes();
    void longTextIsWrapped();
    void notesMakeNoToast();
    void notesThatAreWaitedForMakeOne();
    void atMostThreeToastsTheNewestAtTheBottom();
    void theSameTroubleUpdatesItsToast();
    void cureTakesTheToastAway();
    void toastGoesAfterItsTime();
    void toastStaysUnderTheMouse();
    void clickOnAToastOpensThePanel();
    void toastNeverStealsTheFocus();
    void toastsFollowTheCorner();
    void anOfferStaysUntilItIsTakenOrCured();
    void anOfferIsTakenInItsRowByMouseAndKey();
};

void tst_Notifications::initTestCase() {
    applyTheme(Theme::Dark);
}

void tst_Notifications::newestIsFirst() {
    NotificationModel model;
    model.push(QStringLiteral("a"), Severity::Note, QStringLiteral("first"), noon);
    model.push(QStringLiteral("b"), Severity::Error, QStringLiteral("second"), noon.addSecs(1));
    QCOMPARE(model.row(0).text, QStringLiteral("second"));
    model.push(QStringLiteral("a"), Severity::Note, QStringLiteral("third"), noon.addSecs(2));
    QCOMPARE(model.row(0).text, QStringLiteral("third"));
    QCOMPARE(model.rowCount(), 2);
}

void tst_Notifications::theSameTroubleIsCounted() {
    NotificationModel model;
    for (int i = 0; i < 137; ++i)
        model.push(link_key, Severity::Error, no_answer, noon.addSecs(i));
    QCOMPARE(model.rowCount(), 1);
    QCOMPARE(model.row(0).count, 137);
    QCOMPARE(model.row(0).last, noon.addSecs(136));
}

void tst_Notifications::notesAreNotOpenProblems() {
    NotificationModel model;
    model.push(QStringLiteral("saved/R1"), Severity::Note, QStringLiteral("Saved."), noon);
    QCOMPARE(model.openCount(), 0);
    QCOMPARE(model.curedCount(), 0);
}

void tst_Notifications::theProblemsOfARobotAreCuredTogether() {
    NotificationModel model;
    for (const char* key : {"R1/silence", "R1/spawn", "R10/silence"})
        model.push(QString::fromLatin1(key), Severity::Warning, no_answer, noon);
    model.cureAll(QStringLiteral("R1/"));
    QCOMPARE(model.openCount(), 1);
    QCOMPARE(model.curedCount(), 2);
}

void tst_Notifications::curedIsMarkedAndOpensAgainFromOne() {
    NotificationModel model;
    model.push(link_key, Severity::Error, no_answer, noon);
    model.push(link_key, Severity::Error, no_answer, noon);
    QSignalSpy cured(&model, &NotificationModel::cured);
    model.cure(link_key);
    model.cure(link_key);
    model.cure(QStringLiteral("unknown"));
    QCOMPARE(cured.count(), 1);
    QVERIFY(model.row(0).cured);
    QCOMPARE(model.openCount(), 0);
    model.push(link_key, Severity::Error, no_answer, noon);
    QVERIFY(!model.row(0).cured);
    QCOMPARE(model.row(0).count, 1);
}

void tst_Notifications::modelIsSoundThroughAllChanges() {
    NotificationModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    for (int i = 0; i < 20; ++i)
        model.push(QString::number(i % 7), Severity::Warning, QString::number(i), noon);
    model.cure(QStringLiteral("3"));
    model.clearCured();
    model.markRead();
    QCOMPARE(model.rowCount(), 6);
    model.clear();
    QCOMPARE(model.rowCount(), 0);
}

void tst_Notifications::onlyTheNewestAreKept() {
    NotificationModel model;
    for (int i = 0; i < NotificationModel::capacity + 10; ++i)
        model.push(QString::number(i), Severity::Note, QString::number(i), noon);
    QCOMPARE(model.rowCount(), NotificationModel::capacity);
    QCOMPARE(model.row(model.rowCount() - 1).text, QStringLiteral("10"));
}

void tst_Notifications::clearCuredKeepsWhatIsOpen() {
    NotificationModel model;
    model.push(QStringLiteral("a"), Severity::Error, QStringLiteral("open"), noon);
    model.push(QStringLiteral("b"), Severity::Error, QStringLiteral("over"), noon);
    model.cure(QStringLiteral("b"));
    model.clearCured();
    QCOMPARE(model.rowCount(), 1);
    QCOMPARE(model.row(0).text, QStringLiteral("open"));
}

void tst_Notifications::unreadIsToldOnceForEachChange() {
    NotificationModel model;
    QSignalSpy unread(&model, &NotificationModel::unreadChanged);
    model.push(link_key, Severity::Error, no_answer, noon);
    model.push(link_key, Severity::Error, no_answer, noon);
    model.push(QStringLiteral("b"), Severity::Note, QStringLiteral("b"), noon);
    QCOMPARE(unread.count(), 2);
    QCOMPARE(model.unread(), 2);
    model.cure(link_key);
    QCOMPARE(model.unread(), 1);
    model.markRead();
    QCOMPARE(unread.last()[0].toInt(), 0);
    QCOMPARE(unread.count(), 4);
}

void tst_Notifications::sentenceCarriesSeverityCountAndCure_data() {
    QTest::addColumn<int>("pushes");
    QTest::addColumn<bool>("cure");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("once") << 1 << false << "Warning: It rains.";
    QTest::newRow("twice") << 2 << false << QString::fromUtf8("Warning: It rains. ×2");
    QTest::newRow("cured") << 1 << true << "Warning: It rains. (cured)";
}

void tst_Notifications::sentenceCarriesSeverityCountAndCure() {
    QFETCH(int, pushes);
    QFETCH(bool, cure);
    NotificationModel model;
    for (int i = 0; i < pushes; ++i)
        model.push(link_key, Severity::Warning, QStringLiteral("It rains."), noon);
    if (cure)
        model.cure(link_key);
    QTEST(model.index(0).data().toString(), "sentence");
}

void tst_Notifications::severitiesDifferInWordIconAndColor() {
    QSet<QString> seen;
    for (const Severity severity : {Severity::Note, Severity::Warning, Severity::Error})
        seen << severityWord(severity) << severityIcon(severity) << severityColor(severity).name();
    QCOMPARE(seen.size(), 9);
}

void tst_Notifications::seenIsRead() {
    NotificationCenter center;
    QSignalSpy unread(&center, &NotificationCenter::unreadChanged);
    center.push(link_key, Severity::Error, no_answer, std::nullopt, {}, noon);
    QCOMPARE(center.model()->unread(), 1);
    center.show();
    QCOMPARE(center.model()->unread(), 0);
    center.push(link_key, Severity::Error, no_answer, std::nullopt, {}, noon);
    QCOMPARE(center.model()->unread(), 0);
    center.hide();
    center.push(link_key, Severity::Error, no_answer, std::nullopt, {}, noon);
    QCOMPARE(center.model()->unread(), 1);
}

void tst_Notifications::activatingNamesTheKey() {
    NotificationCenter center;
    center.push(link_key, Severity::Error, no_answer, std::nullopt, {}, noon);
    center.show();
    QSignalSpy activated(&center, &NotificationCenter::activated);
    auto* view = center.findChild<QListView*>();
    view->setCurrentIndex(center.model()->index(0));
    QTest::keyClick(view, Qt::Key_Return);
    QCOMPARE(activated.count(), 1);
    QCOMPARE(activated[0][0].toString(), link_key);
}

void tst_Notifications::copyTakesTheSentence() {
    NotificationCenter center;
    center.push(link_key, Severity::Error, no_answer, std::nullopt, {}, noon);
    auto* view = center.findChild<QListView*>();
    view->setCurrentIndex(center.model()->index(0));
    view->actions().constFirst()->trigger();
    QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("2024-05-01T12:00:00 Error: ") + no_answer);
}

void tst_Notifications::emptyCenterSaysWhatComes() {
    NotificationCenter center;
    center.show();
    QVERIFY(center.findChild<EmptyState*>()->isVisible());
    center.push(link_key, Severity::Error, no_answer, std::nullopt, {}, noon);
    QVERIFY(!center.findChild<EmptyState*>()->isVisible());
    center.model()->clear();
    QVERIFY(center.findChild<EmptyState*>()->isVisible());
}

void tst_Notifications::longTextIsWrapped() {
    NotificationCenter center;
    center.push(link_key, Severity::Error, no_answer, std::nullopt, {}, noon);
    center.show();
    auto* view = center.findChild<QListView*>();
    const QModelIndex first = center.model()->index(0);
    center.resize(900, 300);
    const int wide = view->visualRect(first).height();
    center.resize(220, 300);
    QVERIFY(view->visualRect(first).height() > wide);
    QVERIFY(view->visualRect(first).right() <= view->viewport()->width());
}

void tst_Notifications::notesMakeNoToast() {
    QWidget window;
    NotificationModel model;
    ToastStack stack(&window, &model);
    model.push(link_key, Severity::Note, QStringLiteral("fine"), noon);
    QCOMPARE(stack.count(), 0);
    model.push(link_key, Severity::Warning, QStringLiteral("not so fine"), noon);
    QCOMPARE(stack.count(), 1);
}

void tst_Notifications::notesThatAreWaitedForMakeOne() {
    QWidget window;
    NotificationCenter center;
    ToastStack stack(&window, center.model());
    center.push(link_key, Severity::Note, QStringLiteral("Saved 5 files: /tmp"), true);
    QCOMPARE(stack.count(), 1);
    QCOMPARE(window.findChild<Toast*>()->findChild<QTimer*>()->interval(), Toast::note_lifetime_ms);
    center.push(QStringLiteral("quiet"), Severity::Warning, QStringLiteral("known"), false);
    QCOMPARE(stack.count(), 1);
}

void tst_Notifications::atMostThreeToastsTheNewestAtTheBottom() {
    QWidget window;
    window.resize(800, 600);
    NotificationModel model;
    ToastStack stack(&window, &model);
    for (int i = 0; i < 5; ++i)
        model.push(QString::number(i), Severity::Error, QString::number(i), noon);
    QCOMPARE(stack.count(), ToastStack::most);
    QMap<int, QString> by_height;
    for (const Toast* toast : window.findChildren<Toast*>())
        if (!toast->isHidden())
            by_height[toast->y()] = toast->text();
    QCOMPARE(by_height.values(), (QStringList{"2", "3", "4"}));
}

void tst_Notifications::theSameTroubleUpdatesItsToast() {
    QWidget window;
    NotificationModel model;
    ToastStack stack(&window, &model);
    model.push(link_key, Severity::Error, QStringLiteral("retrying in 4 s"), noon);
    model.push(link_key, Severity::Error, QStringLiteral("retrying in 8 s"), noon);
    QCOMPARE(stack.count(), 1);
    QCOMPARE(window.findChild<Toast*>()->text(), QStringLiteral("retrying in 8 s"));
}

void tst_Notifications::cureTakesTheToastAway() {
    QWidget window;
    NotificationModel model;
    ToastStack stack(&window, &model);
    model.push(link_key, Severity::Error, no_answer, noon);
    model.cure(link_key);
    QCOMPARE(stack.count(), 0);
    model.push(link_key, Severity::Error, no_answer, noon);
    model.clear();
    QCOMPARE(stack.count(), 0);
}

void tst_Notifications::toastGoesAfterItsTime() {
    QWidget window;
    NotificationModel model;
    ToastStack stack(&window, &model);
    model.push(link_key, Severity::Error, no_answer, noon);
    QCOMPARE(stack.count(), 1);
    auto* life = window.findChild<Toast*>()->findChild<QTimer*>();
    QVERIFY(life->isActive());
    QCOMPARE(life->interval(), Toast::lifetime_ms);
    life->start(1);
    QTRY_COMPARE(stack.count(), 0);
}

void tst_Notifications::toastStaysUnderTheMouse() {
    QWidget window;
    NotificationModel model;
    ToastStack stack(&window, &model);
    model.push(link_key, Severity::Error, no_answer, noon);
    auto* toast = window.findChild<Toast*>();
    QEnterEvent enter({5, 5}, {5, 5}, {5, 5});
    QCoreApplication::sendEvent(toast, &enter);
    QVERIFY(!toast->findChild<QTimer*>()->isActive());
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(toast, &leave);
    QVERIFY(toast->findChild<QTimer*>()->isActive());
}

void tst_Notifications::clickOnAToastOpensThePanel() {
    QWidget window;
    window.resize(800, 600);
    NotificationModel model;
    ToastStack stack(&window, &model);
    QSignalSpy open(&stack, &ToastStack::openRequested);
    window.show();
    model.push(link_key, Severity::Error, no_answer, noon);
    auto* toast = window.findChild<Toast*>();
    QTest::mouseClick(toast, Qt::LeftButton, {}, QPoint(60, toast->height() - 12));
    QCOMPARE(open.count(), 1);
    QCOMPARE(open[0][0].toString(), link_key);
    QCOMPARE(stack.count(), 0);
    model.push(link_key, Severity::Error, no_answer, noon);
    toast = nullptr;
    for (Toast* each : window.findChildren<Toast*>())
        toast = each->isHidden() ? toast : each;
    QTest::mouseClick(toast->findChild<QToolButton*>(), Qt::LeftButton);
    QCOMPARE(stack.count(), 0);
    QCOMPARE(open.count(), 1);
}

void tst_Notifications::toastNeverStealsTheFocus() {
    QWidget window;
    window.resize(800, 600);
    QLineEdit edit(&window);
    NotificationModel model;
    ToastStack stack(&window, &model);
    window.show();
    window.activateWindow();
    edit.setFocus();
    QTRY_VERIFY(edit.hasFocus());
    model.push(link_key, Severity::Error, no_answer, noon);
    auto* toast = window.findChild<Toast*>();
    QTest::mousePress(toast, Qt::LeftButton, {}, QPoint(60, toast->height() - 12));
    QVERIFY(edit.hasFocus());
    QVERIFY(!toast->isWindow());
}

void tst_Notifications::toastsFollowTheCorner() {
    QWidget window;
    window.resize(800, 600);
    NotificationModel model;
    ToastStack stack(&window, &model);
    window.show();
    model.push(link_key, Severity::Error, no_answer, noon);
    const auto* toast = window.findChild<Toast*>();
    QCOMPARE(toast->geometry().bottomRight(), QPoint(800 - 17, 600 - 17));
    window.resize(300, 400);
    QTRY_COMPARE(toast->geometry().bottomRight(), QPoint(300 - 17, 400 - 17));
    QVERIFY(toast->x() >= 16);
}

void tst_Notifications::anOfferStaysUntilItIsTakenOrCured() {
    QWidget window;
    window.resize(800, 600);
    NotificationModel model;
    ToastStack stack(&window, &model);
    window.show();
    QSignalSpy taken(&model, &NotificationModel::offerTaken);
    const Offer offer{QStringLiteral("Start R2 again"), QStringLiteral("The same (Ctrl+Return)")};
    model.push(QStringLiteral("r2"), Severity::Warning, QStringLiteral("It died."), noon, {}, offer);
    QVERIFY(!window.findChild<Toast*>()->findChild<QTimer*>()->isActive());
    model.push(link_key, Severity::Error, no_answer, noon);
    for (const Toast* toast : window.findChildren<Toast*>())
        if (toast->key() == link_key)
            toast->findChild<QTimer*>()->start(1);
    QTRY_COMPARE(window.findChildren<Toast*>().size(), 1); // the other one has gone by itself
    auto* const button = window.findChild<QPushButton*>();
    QVERIFY(button->isVisible());
    QCOMPARE(button->text(), offer.text);
    QCOMPARE(button->toolTip(), offer.help);
    QVERIFY(button->height() >= minimum_target);
    QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(taken.size(), 1);
    QCOMPARE(taken[0][0].toString(), QStringLiteral("r2"));
    model.cure(QStringLiteral("r2"));
    QCOMPARE(stack.count(), 0);
    model.takeOffer(QStringLiteral("r2"));
    QCOMPARE(taken.size(), 1);
}

void tst_Notifications::anOfferIsTakenInItsRowByMouseAndKey() {
    NotificationCenter center;
    center.resize(400, 300);
    center.push(QStringLiteral("r2"), Severity::Warning, QStringLiteral("It died."), true,
                Offer{QStringLiteral("Again"), {}});
    center.push(QStringLiteral("a"), Severity::Warning, QStringLiteral("It rains."));
    center.show();
    QVERIFY(QTest::qWaitForWindowExposed(&center));
    auto* const list = center.findChild<QListView*>();
    QSignalSpy taken(center.model(), &NotificationModel::offerTaken);
    QSignalSpy activated(&center, &NotificationCenter::activated);
    const QRect row = list->visualRect(center.model()->index(1));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, row.center() - QPoint(100, 10)); // on the sentence
    QCOMPARE(taken.size(), 0);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, row.bottomRight() - QPoint(30, 14));
    QCOMPARE(taken.size(), 1);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Return);
    QCOMPARE(taken.size(), 2);
    QCOMPARE(activated.size(), 0);
    list->setCurrentIndex(center.model()->index(0));
    QTest::keyClick(list, Qt::Key_Return);
    QCOMPARE(taken.size(), 2);
    QCOMPARE(activated.size(), 1);
}

USAR_TEST(tst_Notifications)

} // namespace tst_notifications

#include "tst_notifications.moc"
