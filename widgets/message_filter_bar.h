// The tools above the list of traffic: what is searched, and which lines are shown.
#pragma once

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QTimer>
#include <QWidget>

#include "widgets/models/message_filter.h"
#include "widgets/type_choice_button.h"

namespace usar::widgets {

/// Text, name, types and direction; `only_trouble` belongs to the action given. An expression that is not valid is
/// said at its field and is no filter yet. GUI thread.
class MessageFilterBar : public QWidget {
    Q_OBJECT
public:
    explicit MessageFilterBar(QAction* only_trouble, QWidget* parent = nullptr);

    /// Without a connection, which is not chosen here.
    MessageFilter filter() const;
    void setFilter(const MessageFilter& filter);
    TypeChoiceButton* types() const { return types_; }
    /// What follows the filters in the row.
    void addButton(QAction* action);
    void focusSearch();
    /// Escape in a field empties it.
    QSize minimumSizeHint() const override { return {200, QWidget::minimumSizeHint().height()}; }

signals:
    void filterChanged();

private:
    QString validWords() const;
    void showExpression();

    QLineEdit* search_;
    QLineEdit* name_;
    TypeChoiceButton* types_;
    QComboBox* way_;
    QAction* only_trouble_;
    QHBoxLayout* row_;
    bool setting_ = false;
};

} // namespace usar::widgets
