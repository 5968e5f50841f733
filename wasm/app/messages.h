#pragma once

#include <string>
#include <utility>
#include <vector>

namespace marey::app {

enum class MessageKind { Note, Warning, Error };

/// Something that the user should read: it stays until they close it.
struct Message {
  MessageKind kind = MessageKind::Error;
  std::string title;   ///< "walk.bvh could not be opened"
  std::string detail;  ///< where and why, and what to do
  std::string command;  ///< id of a command that a button offers, ""
};

/// The unread messages, newest first. A repeated message moves to the front instead of piling up.
class Messages {
 public:
  void add(Message message);
  /// 0 <= index < list().size()
  void close(int index) { list_.erase(list_.begin() + index); }
  void clear() { list_.clear(); }
  [[nodiscard]] const std::vector<Message>& list() const { return list_; }

 private:
  std::vector<Message> list_;
};

}  // namespace marey::app
