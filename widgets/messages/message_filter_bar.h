// Tool bar above the list of traffic: search text, choice of types, and filters.
#pragma once

#include <functional>

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QToolButton>
#include <QWidget>

#include "widgets/models/messages/message_filter.h"

namespace usar::widgets {

/// The list opens below the button and stays open while boxes are checked. GUI thread.
class TypeChoiceButton : public QToolButton {
    Q_OBJECT
public:
    /// Number of lines of each type; queried whenever the list opens.
    using Counts = std::map<std::string, int, std::less<>>;

    explicit TypeChoiceButton(QWidget* parent = nullptr);

    void setCounts(std::function<Counts()> counts) { counts_ = std::move(counts); }
    const TypeChoice& choice() const { return choice_; }
    /// Sets the choice without emitting choiceChanged.
    void setChoice(const TypeChoice& choice);
    /// Lists the types seen so far and those already chosen, with check boxes.
    void openList();
    /// The list of the popup; owned by the button.
    QListWidget* list() const { return list_; }
    QSize sizeHint() const override;

signals:
    /// By the user.
    void choiceChanged();

private:
    QWidget* makePopup();
    void fill();
    void choose(const TypeChoice& choice);
    void takeTick(const QListWidgetItem* item);
    void showChoice();

    std::function<Counts()> counts_;
    TypeChoice choice_;
    QListWidget* list_ = nullptr; ///< made with the popup
    QWidget* popup_;
};

/// Filters by text, name, types and direction; the filter for lines with errors is the action passed in. An invalid
/// regular expression is reported at its field and does not filter. GUI thread.
class MessageFilterBar : public QWidget {
    Q_OBJECT
public:
    /// `only_trouble` gets a button here and must outlive the bar.
    explicit MessageFilterBar(QAction* only_trouble, QWidget* parent = nullptr);

    /// The filter as set here; its connection is always empty, because it is chosen elsewhere.
    MessageFilter filter() const;
    /// Sets all fields and emits filterChanged once.
    void setFilter(const MessageFilter& filter);
    TypeChoiceButton* types() const { return types_; }
    /// Appends a button for `action` to the row.
    void addButton(QAction* action);
    /// Moves the focus to the search field and selects its text.
    void focusSearch();
    /// Small, because the fields can shrink.
    QSize minimumSizeHint() const override { return {200, QWidget::minimumSizeHint().height()}; }

signals:
    void filterChanged();

private:
    /// The search text; empty while it is an invalid regular expression.
    QString validWords() const;
    /// Marks an invalid regular expression and explains it in the tooltip.
    void showExpression();

    QLineEdit* search_;
    QLineEdit* name_;
    TypeChoiceButton* types_ = new TypeChoiceButton(this);
    QComboBox* way_ = new QComboBox(this);
    QAction* only_trouble_;
    QHBoxLayout* row_ = new QHBoxLayout(this);
    bool setting_ = false;
};

} // namespace usar::widgets
