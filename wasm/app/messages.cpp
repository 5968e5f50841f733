#include "wasm/app/messages.h"

#include <algorithm>

namespace marey::app {

void Messages::add(Message message) {
  const auto same = [&](const Message& other) { return other.title == message.title && other.detail == message.detail; };
  list_.erase(std::remove_if(list_.begin(), list_.end(), same), list_.end());
  list_.insert(list_.begin(), std::move(message));
}

}  // namespace marey::app
