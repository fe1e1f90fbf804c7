#include "tests/e2e/inspector_page.h"

#include <QListWidget>

using namespace usar;

/// The offscreen platform leaves a popup active that is gone.
void InspectorPage::activate() {
    page_.window().activateWindow();
    if (!QTest::qWaitForWindowActive(&page_.window()))
        QTest::qFail("the window is not active", __FILE__, __LINE__);
}

void InspectorPage::filterBy(const QString& field, const QString& words) {
    auto* line = list().bar()->findChild<QLineEdit*>(field);
    QTest::mouseClick(line, Qt::LeftButton);
    line->selectAll();
    QTest::keyClick(line, Qt::Key_Delete);
    QTest::keyClicks(line, words);
}

void InspectorPage::chooseTypes(const QStringList& types) {
    auto* button = list().bar()->types();
    QTest::mouseClick(button, Qt::LeftButton);
    QListWidget* choices = button->list();
    for (QPushButton* none : choices->window()->findChildren<QPushButton*>())
        if (none->text() == "None")
            QTest::mouseClick(none, Qt::LeftButton);
    for (int i = 0; i < choices->count(); ++i)
        if (types.contains(choices->item(i)->text().section("  (", 0, 0))) {
            choices->scrollToItem(choices->item(i));
            const QRect row = choices->visualItemRect(choices->item(i));
            QTest::mouseClick(choices->viewport(), Qt::LeftButton, {}, QPoint(12, row.center().y())); // on its box
        }
    QTest::keyClick(choices, Qt::Key_Escape);
    activate();
}

void InspectorPage::chooseDirection(const QString& words) {
    auto* way = list().bar()->findChild<QComboBox*>();
    const int index = way->findText(words);
    while (way->currentIndex() != index)
        QTest::keyClick(way, way->currentIndex() < index ? Qt::Key_Down : Qt::Key_Up);
}

void InspectorPage::pressButton(const QString& command) {
    const QAction* action = page_.window().commands().action(command);
    for (QToolButton* button : list().findChildren<QToolButton*>())
        if (button->defaultAction() == action && button->isVisible())
            return QTest::mouseClick(button, Qt::LeftButton);
    QTest::qFail(qPrintable("no button for " + command), __FILE__, __LINE__);
}

void InspectorPage::clickRow(int row) {
    QTableView* view = list().view();
    const QModelIndex index = view->model()->index(row, widgets::MessageModel::Type);
    view->scrollTo(index);
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, view->visualRect(index).center());
}

bool InspectorPage::allRows(const std::function<bool(const widgets::MessageRow&)>& fit) {
    for (int row = 0; row < rows(); ++row)
        if (!fit(list().model().row(row)))
            return false;
    return rows() > 0;
}

int InspectorPage::rowOf(const std::string& text) {
    for (int row = rows() - 1; row >= 0; --row)
        if (list().model().row(row).text == text)
            return row;
    return -1;
}

int InspectorPage::countOf(const std::string& text) {
    int count = 0;
    for (int row = 0; row < rows(); ++row)
        count += list().model().row(row).text == text;
    return count;
}

void InspectorPage::type(const QString& words) {
    activate();
    page_.pressKey(Qt::Key_F4);
    QTest::keyClicks(QApplication::focusWidget(), words);
}
