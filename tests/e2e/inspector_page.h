// The dock of messages as a person uses it: its filters, its rows, its buttons and its command box.
#pragma once

#include <functional>

#include <QAbstractItemView>
#include <QComboBox>
#include <QCompleter>
#include <QLineEdit>

#include "tests/e2e/window_page.h"

/// Gestures go through mouse and key events only; what is read is what is shown.
class InspectorPage {
public:
    explicit InspectorPage(WindowPage& page) : page_(page) {}

    usar::widgets::MessageList& list() { return *page_.window().views().messages; }
    usar::widgets::CommandBox& box() { return *page_.window().views().command_box; }
    int rows() { return list().model().rowCount(); }
    QString count() { return page_.window().views().message_count->text(); }

    /// Into the field of that object name, whatever it held.
    void filterBy(const QString& field, const QString& words);
    /// Ticks only these types in the list of types.
    void chooseTypes(const QStringList& types);
    void chooseDirection(const QString& words);
    /// Presses the button of that command in the dock.
    void pressButton(const QString& command);
    void clickRow(int row);
    /// True where there is a row and all shown ones are so.
    bool allRows(const std::function<bool(const usar::widgets::MessageRow&)>& fit);
    /// The newest shown row with this text; -1 where there is none.
    int rowOf(const std::string& text);
    /// How many shown rows have this text.
    int countOf(const std::string& text);
    /// Into the command box, which gets the focus by its key.
    void type(const QString& words);
    /// To whatever has the focus.
    void press(Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); }

private:
    void activate();

    WindowPage& page_;
};
