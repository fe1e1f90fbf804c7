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

    /// Sets the function that is called for the counts; without one only chosen types are listed.
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
    /// Makes the popup with the list and the buttons for all types and none; shown by openList.
    QWidget* makePopup();
    /// Lists the types with check boxes, at most 300, because a faulty server may send any number of them.
    void fill();
    /// Sets the choice as if the user had made it; emits choiceChanged if it is another one.
    void choose(const TypeChoice& choice);
    /// Adds or removes the type of an item that the user checked or unchecked.
    void takeTick(const QListWidgetItem* item);
    /// Shows the choice as the button's text: "All types", "All but 2", or the type's name.
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
    /// The button for the choice of types; owned by the bar.
    TypeChoiceButton* types() const { return types_; }
    /// Appends a button for `action` to the row.
    void addButton(QAction* action);
    /// Moves the focus to the search field and selects its text.
    void focusSearch();
    /// Small, because fields that filter nothing make room.
    QSize minimumSizeHint() const override { return {200, QWidget::minimumSizeHint().height()}; }

signals:
    /// The result of filter() may have changed, by the user or by setFilter.
    void filterChanged();

protected:
    void resizeEvent(QResizeEvent* event) override;

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
