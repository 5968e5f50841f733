#include "wasm/app/faults.h"

#include <exception>
#include <new>
#include <stdexcept>

namespace marey::app {

std::optional<Fault> catch_fault(const std::function<void()>& act) {
  try {
    act();
    return std::nullopt;
  } catch (const std::bad_alloc&) {
    return Fault{true, "out of memory"};
  } catch (const std::length_error& error) {
    // A vector beyond what addresses can reach.
    return Fault{true, error.what()};
  } catch (const std::exception& error) {
    return Fault{false, error.what()};
  } catch (...) {
    return Fault{false, "an exception without words"};
  }
}

Error out_of_memory(std::string_view action) {
  return Error{DiagnosticCode::OutOfMemory, {},
               "There is not enough memory for " + std::string(action) +
                   ". Download your changes, close other tabs, or use the command line for a very large file.",
               "", ""};
}

Status with_memory_for(std::string_view action, const std::function<Status()>& change) {
  Status status;
  try {
    status = change();
  } catch (const std::bad_alloc&) {
    status = out_of_memory(action);
  } catch (const std::length_error&) {
    status = out_of_memory(action);
  }
  return status;
}

}  // namespace marey::app
